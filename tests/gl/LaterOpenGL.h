// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/OpenGLProfile.h>

// More constants of OpenGL after 1.1, the version of Windows' headers, that OSG does not define either.
#ifndef GL_PRIMITIVES_GENERATED
#define GL_PRIMITIVES_GENERATED 0x8C87
#endif
#ifndef GL_MAJOR_VERSION
#define GL_MAJOR_VERSION 0x821B
#define GL_MINOR_VERSION 0x821C
#endif
#ifndef GL_CONTEXT_COMPATIBILITY_PROFILE_BIT
#define GL_CONTEXT_COMPATIBILITY_PROFILE_BIT 0x00000002
#endif
