# cmake -DSPIRV_OPT=... -DINPUT=x.spv -DOUTPUT=x.h -DSYMBOL=name -P embed_spirv.cmake
# Optimises a SPIR-V module and writes it as a C++ array of words.
include(${CMAKE_CURRENT_LIST_DIR}/spirv_passes.cmake)
execute_process(
    COMMAND ${SPIRV_OPT} --target-env=vulkan1.2 --scalar-block-layout ${spirvPasses} ${INPUT} -o ${INPUT}.opt
    OUTPUT_VARIABLE remarks ERROR_VARIABLE remarks RESULT_VARIABLE failed)  # remarks: what it could not inline
if(failed)
    message(FATAL_ERROR "spirv-opt failed on ${INPUT}:\n${remarks}")
endif()
file(READ ${INPUT}.opt hex HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${hex}")  # little-endian words
file(WRITE ${OUTPUT} "#pragma once\n#include <cstdint>\n\ninline constexpr std::uint32_t ${SYMBOL}[] = {${words}};\n")
