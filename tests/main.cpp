// SPDX-License-Identifier: BSL-1.0
// The one main of all tests, for Catch2 3 and 2.13.
#define CATCH_CONFIG_RUNNER // Catch2 2.13: its implementation is compiled here
#include "tests/catch.hpp"
#include "tests/project.hpp"

std::string project_folder() { return ANSATZ_PROJECT_FOLDER; }

int main(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }
