// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Structured inputs from the bytes of a fuzzer: numbers, and small meshes that are damaged.
 */
#ifndef FuzzInput_h
#define FuzzInput_h

#include "Core/Common/Mesh.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace fuzz
{
using hexsweep::Index;
using hexsweep::Points;

/// Takes numbers off the bytes; zeros when they are used up, so that every input means something.
class Input
{
public:
  Input(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }

  bool isEmpty() const { return this->Used >= this->Size; }
  std::uint8_t byte() { return this->isEmpty() ? std::uint8_t{ 0 } : this->Data[this->Used++]; }
  /// In [from, to].
  Index whole(Index from, Index to);
  /// Mostly in [1, few], now and then in [1, many]: small inputs are the fast ones.
  Index count(Index few, Index many);
  /// True once in so many times.
  bool rarely(Index times) { return this->whole(1, times) == 1 && !this->isEmpty(); }
  /// In [0, 1].
  double share();
  /// Any bits: not a number and infinity too.
  double bits();
  /// One of the numbers that programs stumble over, or any.
  double special();

private:
  const std::uint8_t* Data;
  std::size_t Size;
  std::size_t Used = 0;
};

/**
 * Asks to stop after a quarter of a second: damage makes a large mesh of a few inputs, and the
 * work for some is bounded and long all the same. What does not hear it for a minute hangs.
 */
hexsweep::Progress patience();

/// Runs the code under test: it may refuse its input by one of Core's errors, and do nothing else.
void expectOrderly(const std::function<void()>& work);

/**
 * Up to six damages of a mesh: faces left out, doubled and turned over; corners welded, torn apart
 * and drawn together; coordinates shaken, and replaced by special numbers; the whole moved and
 * scaled. Corners stay rows of the points. At least one face is left.
 */
template <typename Faces>
void damage(Input& input, Points& points, Faces& faces);

/// Damages of places alone.
void damagePoints(Input& input, Points& points);

/// The diagonal of the box about the points, or 1 where that is no use as a length.
double extentOf(const Points& points);

/// Whether a size is neither so small that it is refused by estimate nor large enough for a mesh of
/// few cells: what lies between takes long and tells no more.
bool isLaborious(double size, double extent);
}

#endif
