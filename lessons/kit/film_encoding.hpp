// What ffmpeg is told of films in formats that it makes.
#pragma once

#include <string>

#include <cairn/math/list.hpp>

namespace cairn {

/// An MP4 that browsers play: H.264 with half the colour samples, and so with sides of even length.
inline List<std::string> mp4_encoding() {
  return {"-c:v",      "libx264",   "-crf", "18",
          "-pix_fmt",  "yuv420p",   "-vf",  "crop=trunc(iw/2)*2:trunc(ih/2)*2",
          "-movflags", "+faststart"};
}

/// A GIF with a palette of its own, and without dots: the usual one dithers what is drawn in few colours.
inline List<std::string> gif_encoding() {
  return {"-vf", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none", "-loop", "0"};
}

}  // namespace cairn
