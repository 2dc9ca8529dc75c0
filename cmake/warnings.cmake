# Warnings of our own targets. They stop a build only where CMAKE_COMPILE_WARNING_AS_ERROR is set: in the presets that developers use.
function(pendula_warnings target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
        -Wconversion -Wno-sign-conversion  # what g++ means by it, of clang too
        -Wno-missing-field-initializers)   # what an initialiser leaves out has its default
endfunction()
