// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

/// Where the checkout lies that the tests were built in; main.cpp was compiled for it, so that the tests need not be.
/// __FILE__ is relative to the build folder, for the same object in every checkout.
std::string project_folder();
