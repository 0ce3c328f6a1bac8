// SPDX-License-Identifier: BSL-1.0
// Empty: the precompiled header of the exercises is built with this file, once, and used by all.
