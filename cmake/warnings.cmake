# Warnings for the targets of pendula. They are errors only if CMAKE_COMPILE_WARNING_AS_ERROR is set, as in the presets for
# developers.
function(pendula_warnings target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
        -Wconversion -Wno-sign-conversion  # for clang: -Wconversion as g++ defines it
        -Wno-missing-field-initializers)   # a member that an initialiser omits has its default
endfunction()
