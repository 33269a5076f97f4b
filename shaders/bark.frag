// SPDX-License-Identifier: MIT

#pragma import_defines(FADING)

#include "bark_texture.glsl"
#include "dither.glsl"
#include "scene.glsl"
#include "surface.glsl"

in vec3 barkCoord;
in vec2 barkGirth;
in vec3 barkLight;
in vec3 scenePosition;
flat in float treeFade;

void main() {
#ifdef FADING
    if (dithered(treeFade))
        discard;
#endif
    float inside = gl_FrontFacing ? 1.0 : 0.4;
    vec3 albedo = inside * barkAlbedo(coordOnBark(barkCoord), barkGirth);
    paintSurface(sceneColor(albedo * shadowed(barkLight, sunLight, scenePosition), scenePosition), albedo);
}
