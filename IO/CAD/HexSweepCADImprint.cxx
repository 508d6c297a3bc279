// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADImprint.h"

#include "Core/Common/Errors.h"
#include "HexSweepCADRepair.h"
#include "HexSweepCADRun.h"

#include <BOPAlgo_Builder.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>

#include <algorithm>

namespace hexsweep
{
namespace
{
/// What became of a shape.
std::vector<TopoDS_Shape> imagesOf(BOPAlgo_Builder& fuse, const TopoDS_Shape& shape)
{
  std::vector<TopoDS_Shape> images;
  if (fuse.IsDeleted(shape))
  {
    return images;
  }
  const TopTools_ListOfShape& modified = fuse.Modified(shape);
  for (const TopoDS_Shape& image : modified)
  {
    images.push_back(image);
  }
  if (images.empty())
  {
    images.push_back(shape);
  }
  return images;
}

/// Names of the solids that have something in common with others.
std::vector<std::string> overlapping(BOPAlgo_Builder& fuse, const CADModel& model)
{
  std::vector<std::vector<TopoDS_Shape>> images;
  TopTools_MapOfShape once;
  TopTools_MapOfShape twice;
  for (const CADSolid& solid : model.solids)
  {
    images.push_back(imagesOf(fuse, solid.shape));
    for (const TopoDS_Shape& image : images.back())
    {
      if (!once.Add(image))
      {
        twice.Add(image);
      }
    }
  }
  std::vector<std::string> names;
  for (std::size_t s = 0; s < images.size(); ++s)
  {
    const bool shares = std::any_of(images[s].begin(), images[s].end(),
      [&](const TopoDS_Shape& image) { return twice.Contains(image); });
    if (images[s].size() != 1 || shares)
    {
      names.push_back("\"" + model.solids[s].name + "\"");
    }
  }
  return names;
}
}

void imprintAndMerge(CADModel& model, double tolerance, const Progress& progress)
{
  if (model.solids.size() < 2)
  {
    return;
  }
  const SilencedCAD silenced;
  BOPAlgo_Builder fuse;
  for (const CADSolid& solid : model.solids)
  {
    fuse.AddArgument(solid.shape);
  }
  fuse.SetNonDestructive(true);
  fuse.SetRunParallel(false);
  fuse.SetFuzzyValue(tolerance * model.size);
  opencascade::handle<CADProgress> shown = new CADProgress(progress);
  const auto complain = [&](const std::string& why) {
    model.complaints.push_back("the solids are not imprinted on each other, and share no faces: " +
      why + " Switch ImprintAndMerge off to be rid of this message.");
  };
  try
  {
    fuse.Perform(shown->Start());
    shown->check();
    if (fuse.HasErrors())
    {
      complain("the CAD kernel found no way.");
      return;
    }
    const std::vector<std::string> names = overlapping(fuse, model);
    if (!names.empty())
    {
      complain(listWords(names) + " overlap. Mend this in the CAD system.");
      return;
    }
    std::vector<CADFaceLabel> labels;
    for (const CADFaceLabel& label : model.labels)
    {
      for (const TopoDS_Shape& image : imagesOf(fuse, label.face))
      {
        labels.push_back({ image, label.name, label.color });
      }
    }
    model.labels = std::move(labels);
    for (CADSolid& solid : model.solids)
    {
      const TopoDS_Shape image = imagesOf(fuse, solid.shape).front();
      solid.shape = image;
    }
  }
  catch (const Standard_Failure& failure)
  {
    complain(describeFailure(failure) + ".");
  }
}
}
