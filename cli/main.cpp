#include "cli/command.h"

int main(int argc, char** argv) { return luxdeck::cli::runProgram(argc, argv); }
