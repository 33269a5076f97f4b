// SPDX-License-Identifier: MIT
// Light 0 of the scene, as OSG sets it up, and a sky that is brighter above than below.

vec3 lightDirection(vec3 eyePosition) {
    vec4 light = gl_LightSource[0].position;
    return normalize(light.xyz - light.w * eyePosition);
}

vec3 ambientLight(vec3 eyeNormal) {
    vec3 eyeUp = normalize(gl_NormalMatrix * vec3(0.0, 0.0, 1.0));
    float sky = 0.5 + 0.5 * dot(eyeNormal, eyeUp);
    vec3 ambient = gl_LightSource[0].ambient.rgb + gl_LightModel.ambient.rgb;
    return ambient * mix(vec3(0.75, 0.72, 0.62), vec3(1.1, 1.2, 1.35), sky);
}

/// Light on bark with this normal.
vec3 barkShade(vec3 eyePosition, vec3 eyeNormal) {
    float facing = max(dot(eyeNormal, lightDirection(eyePosition)), 0.0);
    return ambientLight(eyeNormal) + facing * gl_LightSource[0].diffuse.rgb;
}

/// Light on leaves: from both sides, and it shines through them. Linear in the normal, so that the mean of normals
/// gives the mean of lights.
vec3 leafShade(vec3 eyePosition, vec3 eyeNormal) {
    vec3 toLight = lightDirection(eyePosition);
    float facing = dot(eyeNormal, toLight);
    float through = 0.25 * pow(max(dot(normalize(eyePosition), toLight), 0.0), 4.0);
    return ambientLight(eyeNormal) + (max(0.5 * facing + 0.5, 0.0) + through) * gl_LightSource[0].diffuse.rgb;
}
