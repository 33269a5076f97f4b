// SPDX-License-Identifier: MIT
// Light and haze are computed per vertex: they vary slowly, and there are many fragments.
out vec2 place;
out vec4 haze;   // display colour of the haze, and share of the ground that stays visible
out float fine; // visibility of fine detail
#ifdef TUFTS
out float rise, shade; // position along a blade of grass, 0 to 1; random number of the blade
uniform sampler2D tuftWind;
uniform vec3 tuftWindPlace; // corner, 1 / size
uniform float osg_SimulationTime;

/// Displacement of the tip of a blade by the wind, metres.
vec3 bent(vec2 foot, float height) {
    vec2 wind = texture(tuftWind, (foot - tuftWindPlace.xy) * tuftWindPlace.z).xy;
    float speed = length(wind);
    float quiver = sin(6.2832 * fract(2.1 * osg_SimulationTime + 3.0 * shade + dot(foot, vec2(0.31, 0.23))));
    float angle = speed * speed / (speed * speed + 25.0) * (1.0 + 0.2 * quiver);
    return height * vec3(sin(angle) * wind / max(speed, 0.01), cos(angle) - 1.0);
}
#endif
#ifdef SHADOWED
out vec3 eyePosition;
out
#endif
vec3 sunLight;
#ifndef SHADOWED
out vec3 sunOnIt;
#endif
uniform vec4 rim;       // middle of the ground, half of its widths
uniform float rimStart; // haze hides the ground beyond this share of the way to its edge
void main() {
    vec4 vertex = osg_Vertex;
#ifdef LEVEL
    vertex.xy += (-osg_ModelViewMatrix[3].xyz * mat3(osg_ModelViewMatrix)).xy; // the disc follows the eye
#endif
    place = vertex.xy;
#ifdef TUFTS
    rise = osg_MultiTexCoord0.x;
    shade = osg_MultiTexCoord0.y;
    vertex.xyz += rise * bent(place, osg_MultiTexCoord0.z);
#endif
    vec4 eye = osg_ModelViewMatrix * vertex;
#ifdef RELIEF
    vec3 up = normalize(osg_NormalMatrix * osg_Normal);
#else
    vec3 up = normalize(osg_NormalMatrix * vec3(0.0, 0.0, 1.0));
#endif
    float facing = max(dot(up, normalize(osg_LightSource[0].position.xyz)), 0.0);
    facing = mix(0.2, 1.0, facing); // upright blades catch light from the side
    sunLight = facing * osg_LightSource[0].diffuse.rgb;
#ifdef SHADOWED
    eyePosition = eye.xyz;
#else
    sunOnIt = sunLight;
#endif
#ifdef RELIEF
    vec2 way = abs(place - rim.xy) / rim.zw;
    float toRim = max(way.x, way.y);
#else
    float toRim = length(osg_Vertex.xy) / rim.z;
#endif
#ifdef TUFTS
    toRim = 0.0;
#endif
    float kept = (1.0 - smoothstep(rimStart, 1.0, toRim)) * fogLeft(eye.xyz);
    haze = vec4(sceneFog.color.rgb + glow(normalize(eye.xyz * mat3(osg_ModelViewMatrix))), kept);
    fine = 1.0 / (1.0 + dot(eye.xyz, eye.xyz) / (250.0 * 250.0));
    gl_Position = osg_ProjectionMatrix * eye;
}
