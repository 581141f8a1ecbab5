# Writes OUTPUT, a C++ source with the meta objects of those of HEADERS, files below ROOT, that ask Qt for one. MOC reads
# each header alone, in a hundredth of a second: with all that it includes, as CMake's AUTOMOC has it, in half a second.
file(WRITE ${OUTPUT} "")
foreach(header ${HEADERS})
  file(STRINGS ${ROOT}/${header} asks REGEX "Q_OBJECT|Q_GADGET|Q_NAMESPACE" LIMIT_COUNT 1)
  if(asks)
    execute_process(COMMAND ${MOC} -f ${header} ${ROOT}/${header} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    file(APPEND ${OUTPUT} "${text}")
  endif()
endforeach()
