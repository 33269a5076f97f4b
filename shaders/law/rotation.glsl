// SPDX-License-Identifier: MIT
// Rotations from angles. Quaternions are vec4(x, y, z, w). Axes are OSG's (Z up); the thesis' X, Y, Z are (1, 0, 0),
// (0, 0, 1) and (0, -1, 0).

/// Rotation by `angle` radians about a unit axis.
vec4 turnAbout(vec3 axis, float angle) { return vec4(axis * sin(0.5f * angle), cos(0.5f * angle)); }

/// The rotation `first` followed by `second`.
vec4 turnAfter(vec4 second, vec4 first) {
    vec3 a = vec3(second.x, second.y, second.z);
    vec3 b = vec3(first.x, first.y, first.z);
    return vec4(second.w * b + first.w * a + cross(a, b), second.w * first.w - dot(a, b));
}

/// v rotated by the unit quaternion q.
vec3 turnVector(vec4 q, vec3 v) {
    vec3 a = vec3(q.x, q.y, q.z);
    vec3 t = 2.0f * cross(a, v);
    return v + q.w * t + cross(a, t);
}

/// Rotation of a branch about its base (Fig 3.1): Rx(angleYZ) * Rz(-angleXY) about thesis axes, so that wind toward +x
/// moves a tip toward +x, and wind toward thesis +z moves it toward thesis +z.
vec4 branchRotation(float angleXY, float angleYZ) {
    return turnAfter(turnAbout(vec3(1.0f, 0.0f, 0.0f), angleYZ), turnAbout(vec3(0.0f, 1.0f, 0.0f), angleXY));
}

/// First axis of a branch under the law `modal`: across its unit direction, nearest to +x (to +y for a branch along x).
vec3 branchAxis1(vec3 direction) {
    vec3 side = vec3(1.0f, 0.0f, 0.0f);
    if (abs(direction.x) > 0.99f) side = vec3(0.0f, 1.0f, 0.0f);
    return normalize(side - dot(side, direction) * direction);
}

/// Second axis; thesis +z for an upright branch.
vec3 branchAxis3(vec3 direction) { return cross(branchAxis1(direction), direction); }

/// Rotation of a branch about its base by two angles: the rotation vector is angle1 (d x e1) + angle3 (d x e3), with
/// the axes e1 and e3 of the functions above.
vec4 swungRotation(float angle1, float angle3, vec3 direction) {
    vec3 turn =
        angle1 * cross(direction, branchAxis1(direction)) + angle3 * cross(direction, branchAxis3(direction));
    float z = 0.25f * dot(turn, turn); // h^2, with h = half the angle
    if (z > 1.0f) return turnAbout(normalize(turn), length(turn));
    // Taylor's series of sin(h) / h and cos(h)
    float sine = (((2.7557319e-6f * z - 1.9841270e-4f) * z + 8.3333333e-3f) * z - 0.16666667f) * z + 1.0f;
    float cosine =
        ((((-2.7557319e-7f * z + 2.4801587e-5f) * z - 1.3888889e-3f) * z + 4.1666667e-2f) * z - 0.5f) * z + 1.0f;
    return vec4(0.5f * sine * turn, cosine);
}

/// Rotation of a leaf in the leaf frame, with the petiole along +Z (thesis Y), before its rest orientation (Figs 3.11,
/// 3.12): Rx(motionAngleZ) * Rz(motionAngleX) * Ry(totalRotaAngle) about thesis axes.
vec4 leafRotation(float motionAngleX, float motionAngleZ, float totalRotaAngle) {
    return turnAfter(turnAbout(vec3(1.0f, 0.0f, 0.0f), motionAngleZ),
                     turnAfter(turnAbout(vec3(0.0f, -1.0f, 0.0f), motionAngleX),
                               turnAbout(vec3(0.0f, 0.0f, 1.0f), totalRotaAngle)));
}
