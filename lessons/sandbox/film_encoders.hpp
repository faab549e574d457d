// Films in formats that other programs write.
#pragma once

#include <filesystem>

#include "lessons/sandbox/film_files.hpp"

namespace cairn::sandbox {

/// @throws render::WriteError that says what is missing, for a film whose program is not in PATH.
void require_encoders(const FilmFiles& files);

/// From frames 0000.png ... in `folder`. @throws render::WriteError, and Interrupted, without the file.
void encode_gif(const std::filesystem::path& folder, double frames_per_second,
                const std::filesystem::path& target);
void encode_mp4(const std::filesystem::path& folder, double frames_per_second,
                const std::filesystem::path& target);
void encode_webp(const std::filesystem::path& folder, int count, double frames_per_second,
                 const std::filesystem::path& target);

}  // namespace cairn::sandbox
