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
