#include "gui/app/start.h"

int main(int argc, char** argv) { return luxdeck::gui::run(argc, argv); }
