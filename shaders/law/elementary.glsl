// SPDX-License-Identifier: MIT
// Needs limits.glsl. Elementary functions that give nearly the same numbers on every machine, after Moshier's
// Cephes: those of graphics cards are off by up to 2e-4, which would add up from step to step.

/// asin x for x in [-1, 1], within 3e-7.
float arcSine(float x) {
    float a = abs(x);
    bool far = a > 0.5f;
    float z = a * a;
    if (far) {
        z = 0.5f * (1.0f - a);
        a = sqrt(z);
    }
    float p = ((4.2163199048e-2f * z + 2.4181311049e-2f) * z + 4.5470025998e-2f) * z + 7.4953002686e-2f;
    p = p * z + 1.6666752422e-1f;
    float y = a + a * z * p;
    if (far) y = 1.5707963f - 2.0f * y;
    return x < 0.0f ? -y : y;
}

/// e^-x for x >= 0, within 2e-7 of itself; 0 from x = 87 on.
float decayed(float x) {
    if (!(x < 87.0f)) return 0.0f;
    float n = floor(x * 1.44269504f + 0.5f);
    float f = (n * 0.693359375f - x) - n * 2.12194440e-4f; // n ln 2 - x
    float p = ((1.9875691500e-4f * f + 1.3981999507e-3f) * f + 8.3334519073e-3f) * f + 4.1665795894e-2f;
    p = ((p * f + 1.6666665459e-1f) * f + 5.0000001201e-1f) * f * f + f + 1.0f;
    return p * intBitsToFloat((127 - int(n)) << 23);
}

/// (cos x, sin x) for x in [0, 1e4], within 3e-7; within the unit circle beyond.
vec2 cosineSine(float x) {
    float n = floor(min(x, 1.0e7f) * 0.636619772f + 0.5f); // quarter turns
    float r = ((x - n * 1.5703125f) - n * 4.83751297e-4f) - n * 7.54978995e-8f;
    r = bounded(r, 0.8f); // a quarter turn and the rounding of n
    float z = r * r;
    float c = ((2.443315712e-5f * z - 1.388731625e-3f) * z + 4.166664568e-2f) * z * z - 0.5f * z + 1.0f;
    float s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * r + r;
    int quarter = int(n) & 3;
    if (quarter == 0) return vec2(c, s);
    if (quarter == 1) return vec2(-s, c);
    if (quarter == 2) return vec2(-c, -s);
    return vec2(s, -c);
}
