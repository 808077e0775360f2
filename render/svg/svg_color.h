#pragma once
// Colours as SVG writes them: straight ones in eight bits a channel, and an opacity.

#include "render/blend/blender.h"

#include <string>

namespace mien {

/// Of a colour mixed as encoded, premultiplied: "#rrggbb"; black where it is transparent.
std::string svg_color(const Mix& mix);

/// The opacity of a colour or group with the attribute's name, ` fill-opacity=".5"`; nothing where it is 1.
std::string svg_opacity(const char* attribute, double opacity);

}  // namespace mien
