// SPDX-License-Identifier: MIT
// Needs limits.glsl. Elementary functions with nearly the same results on all machines, after Moshier's Cephes. Those
// of graphics cards have errors up to 2e-4, which would accumulate over time steps.

/// asin x for x in [-1, 1], within 3e-7.
real arcSine(real x) {
    real a = abs(x);
    real z = a > 0.5f ? 0.5f * (1.0f - a) : a * a;
    real s = a > 0.5f ? sqrt(z) : a;
    real p = ((4.2163199048e-2f * z + 2.4181311049e-2f) * z + 4.5470025998e-2f) * z + 7.4953002686e-2f;
    p = p * z + 1.6666752422e-1f;
    real y = s + s * z * p;
    y = a > 0.5f ? 1.5707963f - 2.0f * y : y;
    return x < 0.0f ? -y : y;
}

/// e^-x for x >= 0, with a relative error below 2e-7; 0 from x = 87 on.
real decayed(real x) {
    real y = x < 87.0f ? x : every(87.0f);
    real n = floor(y * 1.44269504f + 0.5f);
    real f = (n * 0.693359375f - y) - n * 2.12194440e-4f; // n ln 2 - x
    real p = ((1.9875691500e-4f * f + 1.3981999507e-3f) * f + 8.3334519073e-3f) * f + 4.1665795894e-2f;
    p = ((p * f + 1.6666665459e-1f) * f + 5.0000001201e-1f) * f * f + f + 1.0f;
    return x < 87.0f ? p * halvings(n) : every(0.0f);
}

/// ln x for x in [1, 64], within 5e-7.
real logarithm(real x) {
    real y = x > 8.0f ? x * 0.125f : x;
    real z = y > 2.8284271f ? y * 0.35355339f : y;
    real t = z > 1.6817928f ? z * 0.5f : z; // within [0.84, 1.69]
    real shift = (x > 8.0f ? every(2.07944154f) : every(0.0f)) +
                 (y > 2.8284271f ? every(1.03972077f) : every(0.0f)) +
                 (z > 1.6817928f ? every(0.69314718f) : every(0.0f));
    real s = (t - 1.0f) / (t + 1.0f);
    real q = s * s;
    return shift + 2.0f * s * ((((q * 0.11111111f + 0.14285714f) * q + 0.2f) * q + 0.33333333f) * q + 1.0f);
}

/// A point on the unit circle.
struct CosineSine {
    real cosine;
    real sine;
};

/// cos x and sin x for x in [0, 1e4], within 3e-7. Beyond, the results stay within the unit circle.
CosineSine cosineSine(real x) {
    real n = floor(min(x, every(1.0e7f)) * 0.636619772f + 0.5f); // quarter turns
    real r = ((x - n * 1.5703125f) - n * 4.83751297e-4f) - n * 7.54978995e-8f;
    r = bounded(r, every(0.8f)); // a quarter turn and the rounding of n
    real z = r * r;
    real c = ((2.443315712e-5f * z - 1.388731625e-3f) * z + 4.166664568e-2f) * z * z - 0.5f * z + 1.0f;
    real s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * r + r;
    real quarter = n - 4.0f * floor(n * 0.25f);
    real odd = quarter - 2.0f * floor(quarter * 0.5f);
    real across = odd > 0.5f ? s : c;
    real along = odd > 0.5f ? c : s;
    CosineSine turned;
    turned.cosine = abs(quarter - 1.5f) < 1.0f ? -across : across;
    turned.sine = quarter > 1.5f ? -along : along;
    return turned;
}
