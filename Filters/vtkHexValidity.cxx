// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexValidity.h"

#include "Core/Hexahedra/HexQuality.h"
#include "HexSweepHexReader.h"
#include "HexSweepHexText.h"
#include "HexSweepQualityArrays.h"
#include "HexSweepRun.h"

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
#include <limits>
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

  hexsweep::JudgedHexes judged()
  {
    const auto quality = [this](Index cell) {
      return this->isOwned(cell) ? this->arrays.quality(cell) : notJudged();
    };
    return { this->summary, this->count, quality,
      [this](Index cell) { return this->reader.corners(cell); } };
  }

  vtkIdType count;
  vtkUnsignedCharArray* ghosts;
  HexReader reader;
  QualityArrays arrays;
  hexsweep::HexQualitySummary summary;
};

constexpr const char* Advice = "move their points, or mesh that region anew.";
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
      const std::string problem = hexsweep::describeInverted(cells.judged(), Advice);
      if (this->FailIfInvalid)
      {
        throw hexsweep::InvalidInput(problem);
      }
      vtkWarningMacro(<< problem);
    }
    if (cells.summary.undecided > 0)
    {
      vtkWarningMacro(<< hexsweep::describeUndecided(cells.judged(), Advice));
    }
    output->ShallowCopy(input);
    cells.arrays.addTo(output->GetCellData());
    hexsweep::addQualityReport(output->GetFieldData(), cells.summary);
  });
}
