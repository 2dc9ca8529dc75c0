# Results follow IEEE 754, and so must the code that reads and prints numbers. These options follow those of the user and
# override -ffast-math and the options that it implies. At link time -Ofast adds start-up code that flushes denormal numbers to
# zero, which no later option prevents: it is refused. src/arithmetic/strict.hpp refuses flags that set a macro of the compiler.
add_compile_options(-fno-fast-math)
add_link_options(-fno-fast-math -fno-unsafe-math-optimizations)

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" MATCHES "-Ofast")
    message(FATAL_ERROR "pendula gives the same bits everywhere only by IEEE-754 arithmetic: use -O3 in place of -Ofast")
endif()
