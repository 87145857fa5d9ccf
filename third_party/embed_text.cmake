# embed_text(TARGET HEADER NAMESPACE SYMBOL FILE [SYMBOL FILE]...): text files as constants of TARGET.
# TARGET can then `#include "HEADER"`, which declares `NAMESPACE::SYMBOL`, a std::string_view of each FILE,
# byte for byte. The header is made when CMake configures, and a changed FILE makes CMake configure again.
# No FILE may contain `)EMBEDDED"` or be longer than 64 KiB, the longest literal that every compiler takes.
include_guard(GLOBAL)

function(embed_text target header namespace)
    set(constants "")
    set(rest ${ARGN})
    while(rest)
        list(POP_FRONT rest symbol file)
        file(REAL_PATH "${file}" file)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")

        file(SIZE "${file}" bytes)
        file(READ "${file}" text)
        string(FIND "${text}" ")EMBEDDED\"" end)
        if(bytes GREATER 65535 OR NOT end EQUAL -1)
            message(FATAL_ERROR "${file} is too long to embed, or contains )EMBEDDED\"")
        endif()
        set(literal "R\"EMBEDDED(${text})EMBEDDED\"")
        string(APPEND constants "inline constexpr std::string_view ${symbol} = ${literal};\n")
    endwhile()

    set(folder "${CMAKE_CURRENT_BINARY_DIR}/embedded")
    file(CONFIGURE OUTPUT "${folder}/${header}" @ONLY CONTENT [[// Made by third_party/embed_text.cmake.
#pragma once

#include <string_view>

namespace @namespace@ {

@constants@
}  // namespace @namespace@
]])
    target_include_directories(${target} PRIVATE "${folder}")
endfunction()
