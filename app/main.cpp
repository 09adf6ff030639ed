#include "app/command_line.h"
#include "app/core/crash_report.h"

int main(int argc, char** argv) {
    talus::app::report_crashes();
    return talus::app::command_line(argc, argv);
}
