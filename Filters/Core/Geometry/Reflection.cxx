// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Reflection.h"

#include <array>
#include <cstdlib>
#include <optional>

namespace hexsweep
{
namespace
{
/// Where the three numbers of a place begin and end in a text.
struct PlaceInText
{
  std::array<std::size_t, 3> begin;
  std::array<std::size_t, 3> end;
};

/// @param open index of a '('.
std::optional<PlaceInText> placeAt(const std::string& text, std::size_t open)
{
  PlaceInText place{};
  std::size_t here = open + 1;
  for (std::size_t i = 0; i < 3; ++i)
  {
    char* stop = nullptr;
    std::strtod(text.c_str() + here, &stop);
    const auto end = static_cast<std::size_t>(stop - text.c_str());
    const std::string separator = i < 2 ? ", " : ")";
    if (end == here || text[here] == ' ' || text.compare(end, separator.size(), separator) != 0)
    {
      return std::nullopt;
    }
    place.begin[i] = here;
    place.end[i] = end;
    here = end + separator.size();
  }
  return place;
}

std::string negated(const std::string& number)
{
  if (std::strtod(number.c_str(), nullptr) == 0.0)
  {
    return "0";
  }
  return number.front() == '-' ? number.substr(1) : "-" + number;
}
}

Points reflected(Points points, const Reflection& reflection)
{
  for (Index axis = 0; axis < 3; ++axis)
  {
    // A negative zero plus zero is a positive one.
    points.col(axis) = (points.col(axis).array() * reflection.signs[axis] + 0.0).matrix();
  }
  return points;
}

std::string reflectedPlaces(const std::string& text, const Reflection& reflection)
{
  std::string result;
  std::size_t done = 0;
  for (std::size_t open = text.find('('); open != std::string::npos;
       open = text.find('(', open + 1))
  {
    if (const std::optional<PlaceInText> place = placeAt(text, open))
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::string number = text.substr(place->begin[i], place->end[i] - place->begin[i]);
        result += text.substr(done, place->begin[i] - done);
        result += reflection.signs[static_cast<Index>(i)] < 0.0 ? negated(number) : number;
        done = place->end[i];
      }
    }
  }
  return result + text.substr(done);
}
}
