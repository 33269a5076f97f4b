// SPDX-License-Identifier: MIT
// Needs limits.glsl and elementary.glsl. The exact step of an oscillator, and the drag of a crown.

/// State of an oscillator.
struct Swing {
    real angle;
    real speed;
};

/// The exact solution of x'' + 2 rate x' + pace^2 x = 0 after h seconds. pace and h > 0, rate >= 0.
Swing swungFreely(Swing start, real pace, real rate, real h) {
    real w = pace * h;
    real g = rate * h;
    real larger = max(w, g);
    real ratio = min(w, g) / larger;
    real root = larger * sqrt((1.0f - ratio) * (1.0f + ratio)); // sqrt(|w^2 - g^2|)
    real d = w > g ? root * root : -root * root;
    real size = decayed(g);
    real slow = w > g ? every(0.0f) : decayed(w * (w / (g + root)));
    real fast = w > g ? every(0.0f) : decayed(g + root);
    CosineSine turned = cosineSine(root);
    real cosine = root < 0.1f ? size * (1.0f - d / 2.0f + d * d / 24.0f) // e^-gh cos(sqrt(D) h)
                  : w > g     ? size * turned.cosine
                              : 0.5f * (slow + fast);
    real sine = root < 0.1f ? size * (1.0f - d / 6.0f + d * d / 120.0f) // e^-gh sin(sqrt(D) h) / (sqrt(D) h)
                : w > g     ? size * turned.sine / root
                            : 0.5f * (slow - fast) / root;
    Swing end;
    end.angle = (cosine + g * sine) * start.angle + h * sine * start.speed;
    end.speed = (cosine - g * sine) * start.speed - w * (w / h) * sine * start.angle;
    return end;
}

/// Drag coefficient of a crown over that at 10 m/s, as leaves and twigs align with the wind: u^-exponent from 10 m/s to
/// `upTo`, as measured in wind tunnels, and u^-breeze below, down to 1.6 m/s, where leaves begin to move (Beaufort 2).
/// @param exponent, breeze in [0, 2]. @param upTo, speed in m/s.
real streamlinedShare(real exponent, real breeze, real upTo, real speed) {
    real ratio = max(speed, every(1.6f)) / 10.0f;
    real high = logarithm(ratio < 1.0f ? 8.0f * ratio : min(ratio, upTo / 10.0f));
    real share = decayed(ratio < 1.0f ? breeze * (2.07944154f - high) : exponent * high);
    return ratio < 1.0f ? 1.0f / share : share;
}
