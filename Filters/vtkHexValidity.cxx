// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexValidity.h"

#include "Core/HexQuality.h"
#include "HexSweepBridge.h"
#include "HexSweepHexReader.h"
#include "HexSweepQualityArrays.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHexValidity);

namespace
{
using hexsweep::HexQuality;
using hexsweep::HexReader;
using hexsweep::Index;
using hexsweep::QualityArrays;
using hexsweep::Validity;

constexpr vtkIdType NumberOfNamedCells = 10;
// Between two portions progress is shown and an abort is heard; a portion is shared by the threads
// in pieces.
constexpr Index CellsPerPortion = 1 << 16;
constexpr Index CellsPerPiece = 1 << 10;

HexQuality notJudged()
{
  HexQuality quality;
  quality.scaledJacobian = std::numeric_limits<double>::quiet_NaN();
  quality.validity = Validity::NotJudged;
  return quality;
}

/// Writes the qualities of the cells [begin, end) to an array that starts with cell begin.
void judgePiece(HexReader& reader, Index begin, Index end, HexQuality* qualities)
{
  std::vector<Index> hexes;
  hexes.reserve(static_cast<std::size_t>(end - begin));
  hexsweep::Points corners(8 * (end - begin), 3);
  for (Index cell = begin; cell < end; ++cell)
  {
    if (reader.isHex(cell))
    {
      corners.middleRows<8>(8 * static_cast<Index>(hexes.size())) = reader.corners(cell);
      hexes.push_back(cell);
    }
    else
    {
      qualities[cell - begin] = notJudged();
    }
  }
  const std::vector<HexQuality> judged =
    hexsweep::hexQualities(corners.topRows(8 * static_cast<Index>(hexes.size())));
  for (std::size_t i = 0; i < hexes.size(); ++i)
  {
    qualities[hexes[i] - begin] = judged[i];
  }
}

std::vector<HexQuality> judgePortion(HexReader& reader, Index begin, Index end)
{
  std::vector<HexQuality> qualities(static_cast<std::size_t>(end - begin));
  hexsweep::forPieces(hexsweep::smpFor(), end - begin, CellsPerPiece, [&](Index first, Index last) {
    judgePiece(reader, begin + first, begin + last, qualities.data() + first);
  });
  return qualities;
}

/// A data set with the verdicts on its cells.
struct JudgedCells
{
  explicit JudgedCells(vtkDataSet* data)
    : count(data->GetNumberOfCells())
    , ghosts(data->GetCellGhostArray())
    , reader(data)
    , arrays(count)
  {
  }

  /// Cells that another rank owns, or that are switched off, are not this mesh's to report.
  bool isOwned(vtkIdType cell) const
  {
    constexpr int NotOurs = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
    return !this->ghosts || (this->ghosts->GetValue(cell) & NotOurs) == 0;
  }

  void judge(const hexsweep::Progress& progress)
  {
    for (Index begin = 0; begin < this->count; begin += CellsPerPortion)
    {
      const Index end = std::min<Index>(this->count, begin + CellsPerPortion);
      const std::vector<HexQuality> qualities = judgePortion(this->reader, begin, end);
      for (Index cell = begin; cell < end; ++cell)
      {
        const HexQuality& quality = qualities[static_cast<std::size_t>(cell - begin)];
        this->arrays.set(cell, quality);
        if (this->isOwned(cell))
        {
          this->summary.add(quality);
        }
      }
      hexsweep::reportProgress(
        progress, static_cast<double>(end) / static_cast<double>(this->count));
    }
  }

  /// Names the first cells with one of these verdicts.
  std::string describe(std::initializer_list<Validity> verdicts)
  {
    std::ostringstream text;
    vtkIdType named = 0;
    for (vtkIdType cell = 0; cell < this->count && named < NumberOfNamedCells; ++cell)
    {
      const Validity validity = this->arrays.validity(cell);
      if (std::find(verdicts.begin(), verdicts.end(), validity) == verdicts.end() ||
        !this->isOwned(cell))
      {
        continue;
      }
      const Eigen::RowVector3d center = this->reader.corners(cell).colwise().mean();
      text << "\n  cell " << cell << " at (" << center[0] << ", " << center[1] << ", " << center[2]
           << "), ";
      if (validity == Validity::Degenerate)
      {
        text << "degenerate";
      }
      else
      {
        text << "scaled Jacobian " << this->arrays.scaledJacobian(cell)
             << (validity == Validity::InvertedInside ? ", inverted between its corners" : "");
      }
      ++named;
    }
    return text.str();
  }

  vtkIdType count;
  vtkUnsignedCharArray* ghosts;
  HexReader reader;
  QualityArrays arrays;
  hexsweep::HexQualitySummary summary;
};

std::string describeInverted(JudgedCells& cells)
{
  const hexsweep::HexQualitySummary& summary = cells.summary;
  std::ostringstream text;
  if (summary.insideOut == summary.hexes)
  {
    text << "the mesh is inside out: all " << summary.hexes
         << " hexahedra have negative Jacobians at every corner, because their points are in "
            "left-handed order. Swap the first four points of each hexahedron with the last four.";
    return text.str();
  }
  text << summary.inverted << " of " << summary.hexes << " hexahedra are inverted";
  if (summary.degenerate > 0)
  {
    text << " and " << summary.degenerate
         << " are degenerate (an edge without length, or a coordinate that is not finite)";
  }
  text << ". The first:"
       << cells.describe(
            { Validity::InvertedCorner, Validity::InvertedInside, Validity::Degenerate })
       << "\nThreshold the cell array Validity (1, 2 and 4) to see all of them; move their points, "
          "or mesh that region anew.";
  return text.str();
}

std::string describeUndecided(JudgedCells& cells)
{
  std::ostringstream text;
  text << cells.summary.undecided << " of " << cells.summary.hexes
       << " hexahedra are undecided: their Jacobian comes too near to zero to be told from it. The "
          "first:"
       << cells.describe({ Validity::Undecided })
       << "\nTreat them as inverted: move their points, or mesh that region anew.";
  return text.str();
}
}

void vtkHexValidity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
}

int vtkHexValidity::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hexsweep::runFilter(this, outputs, [&]() {
    vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
    vtkDataSet* output = vtkDataSet::GetData(outputs);
    // Unlike a cap, a mesh of hexahedra may well be spread over the ranks: each judges its own.
    const int piece = outputs->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    if (!input || input->GetNumberOfCells() == 0)
    {
      if (piece > 0)
      {
        return;
      }
      throw hexsweep::InvalidInput("the input is empty (no cells). Connect a mesh of hexahedra.");
    }
    JudgedCells cells(input);
    cells.judge(hexsweep::pipelineProgress(this));
    if (cells.summary.hexes == 0)
    {
      vtkWarningMacro("the input has no hexahedra: nothing was judged.");
    }
    if (cells.summary.inverted + cells.summary.degenerate > 0)
    {
      const std::string problem = describeInverted(cells);
      if (this->FailIfInvalid)
      {
        throw hexsweep::InvalidInput(problem);
      }
      vtkWarningMacro(<< problem);
    }
    if (cells.summary.undecided > 0)
    {
      vtkWarningMacro(<< describeUndecided(cells));
    }
    output->ShallowCopy(input);
    cells.arrays.addTo(output->GetCellData());
    hexsweep::addQualityReport(output->GetFieldData(), cells.summary);
  });
}
