// SPDX-License-Identifier: MIT
// How a leaf card faces the eye.

/// @param toward cosine of the angle between the eye and the normal of the card, [0, 1].
/// @return share of its alpha that the card shows: seen from its edge, its leaves would be streaks; and bias of its
/// mipmap level, between those of its length and of its foreshortened width.
vec2 facingOf(float toward) { return vec2(smoothstep(0.04, 0.16, toward), 0.5 * log2(max(toward, 0.25))); }
