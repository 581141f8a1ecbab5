# Writes OUTPUT, a C++ source that defines `extern const char NAME[]` with the text of INPUT.
file(READ ${INPUT} text)
file(WRITE ${OUTPUT} "extern const char ${NAME}[];\nconst char ${NAME}[] = R\"~~~(${text})~~~\";\n")
