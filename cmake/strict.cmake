# Results follow IEEE 754, and so does what reads and prints them. A user's flags stand before these, which take back -ffast-math
# and all that it is made of. When linking it would add code that has the processor flush subnormal numbers: -Ofast does so
# whatever follows it, and is refused. src/arithmetic/strict.hpp refuses what a compiler's macros tell.
add_compile_options(-fno-fast-math)
add_link_options(-fno-fast-math -fno-unsafe-math-optimizations)

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" MATCHES "-Ofast")
    message(FATAL_ERROR "pendula gives the same bits everywhere only by IEEE-754 arithmetic: use -O3 in place of -Ofast")
endif()
