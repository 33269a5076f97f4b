// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// Number of texture fetches of one invocation of a shader, computed from its text. Counts both sides of each
/// branch, and a loop as often as its bound says if that is a number or a constant, else once. Of conditions
/// of the preprocessor, evaluates only `#ifdef` and `#ifndef`; takes the first side of `#if`.
int textureFetches(const std::string& glsl);
