// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangulated surface that is known to be the cap of a sweep.
 */
#ifndef hexsweep_Cap_h
#define hexsweep_Cap_h

#include "Core/Common/Mesh.h"

#include <string>
#include <utility>

namespace hexsweep
{
/**
 * One oriented piece of genus 0 with a boundary loop or more. What takes a Cap need not check it:
 * makeCap() is its only maker.
 */
class Cap
{
public:
  const TriangleMesh& mesh() const { return this->Mesh; }
  const Points& points() const { return this->Mesh.points; }
  const Triangles& triangles() const { return this->Mesh.triangles; }
  /// As SurfaceTopology::loops.
  const std::vector<Loop>& loops() const { return this->Loops; }

private:
  friend Cap makeCap(TriangleMesh mesh, const std::string& what);
  Cap(TriangleMesh mesh, std::vector<Loop> loops)
    : Mesh(std::move(mesh))
    , Loops(std::move(loops))
  {
  }

  TriangleMesh Mesh;
  std::vector<Loop> Loops;
};

/**
 * Turns the triangles of a surface to agree with the first one, and checks it.
 *
 * @param mesh any orientation.
 * @param what name of the surface for the error text.
 * @throw InvalidInput as orientFaces(), checkSurface() and checkCap().
 */
Cap makeCap(TriangleMesh mesh, const std::string& what);
}

#endif
