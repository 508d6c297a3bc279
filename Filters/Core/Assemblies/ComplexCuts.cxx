// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/ComplexCuts.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>

namespace hexsweep
{
void TriangleList::addCut(const std::array<Index, 3>& triangle, Index face, const CutEdges& cut)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    const Index a = triangle[c];
    const Index b = triangle[(c + 1) % 3];
    const Index apex = triangle[(c + 2) % 3];
    const auto found = cut.find(std::minmax({ a, b }));
    if (found == cut.end())
    {
      continue;
    }
    std::vector<Index> chain = found->second;
    if (a > b)
    {
      std::reverse(chain.begin(), chain.end());
    }
    chain.push_back(b);
    Index last = a;
    for (const Index next : chain)
    {
      // The others of its edges may be cut, too.
      this->addCut({ last, next, apex }, face, cut);
      last = next;
    }
    return;
  }
  this->add(triangle, face);
}

void TriangleList::moveTo(AssemblyComplex& complex)
{
  complex.triangles.resize(static_cast<Index>(this->Corners.size()), 3);
  for (ComplexFace& face : complex.faces)
  {
    face.triangles.clear();
  }
  for (std::size_t t = 0; t < this->Corners.size(); ++t)
  {
    complex.triangles.row(static_cast<Index>(t)) << this->Corners[t][0], this->Corners[t][1],
      this->Corners[t][2];
    complex.faces[at(this->FaceOf[t])].triangles.push_back(static_cast<Index>(t));
  }
  complex.faceOf = std::move(this->FaceOf);
  this->Corners.clear();
  traceCurves(complex);
}

void cutTriangles(const CutEdges& cut, AssemblyComplex& complex)
{
  TriangleList list;
  for (Index t = 0; t < complex.triangles.rows(); ++t)
  {
    list.addCut({ complex.triangles(t, 0), complex.triangles(t, 1), complex.triangles(t, 2) },
      complex.faceOf[at(t)], cut);
  }
  list.moveTo(complex);
}
}
