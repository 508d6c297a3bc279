// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADImprint.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "HexSweepCADRepair.h"
#include "HexSweepCADRun.h"

#include <BOPAlgo_Builder.hxx>
#include <BOPTools_BoxTree.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <Bnd_Tools.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>

#include <algorithm>
#include <map>

namespace hexsweep
{
namespace
{
/// Rows of CADModel::solids.
using SolidGroup = std::vector<std::size_t>;

/// By row of CADModel::labels, what became of the label's face.
using LabelImages = std::vector<std::vector<CADFaceLabel>>;

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

std::vector<std::string> namesOf(const CADModel& model, const SolidGroup& group)
{
  std::vector<std::string> names;
  for (const std::size_t s : group)
  {
    names.push_back("\"" + model.solids[s].name + "\"");
  }
  return names;
}

/// Those solids of a group that have something in common with others.
SolidGroup overlapping(BOPAlgo_Builder& fuse, const CADModel& model, const SolidGroup& group)
{
  std::vector<std::vector<TopoDS_Shape>> images;
  TopTools_MapOfShape once;
  TopTools_MapOfShape twice;
  for (const std::size_t s : group)
  {
    images.push_back(imagesOf(fuse, model.solids[s].shape));
    for (const TopoDS_Shape& image : images.back())
    {
      if (!once.Add(image))
      {
        twice.Add(image);
      }
    }
  }
  SolidGroup found;
  for (std::size_t k = 0; k < images.size(); ++k)
  {
    const bool shares = std::any_of(images[k].begin(), images[k].end(),
      [&](const TopoDS_Shape& image) { return twice.Contains(image); });
    if (images[k].size() != 1 || shares)
    {
      found.push_back(group[k]);
    }
  }
  return found;
}

/// Groups of two solids and more whose boxes overlap, directly or by others: only these can touch.
/// Many small fuses cost far less than one of thousands of solids.
std::vector<SolidGroup> neighbours(const CADModel& model, double tolerance)
{
  const int solids = static_cast<int>(model.solids.size());
  const opencascade::handle<BOPTools_BoxTree> tree = new BOPTools_BoxTree();
  tree->SetSize(solids);
  for (int s = 0; s < solids; ++s)
  {
    Bnd_Box box;
    BRepBndLib::Add(model.solids[static_cast<std::size_t>(s)].shape, box);
    box.Enlarge(tolerance);
    tree->Add(s, Bnd_Tools::Bnd2BVH(box));
  }
  tree->Build();
  BOPTools_BoxPairSelector selector;
  selector.SetBVHSets(tree.get(), tree.get());
  selector.SetSame(true);
  selector.Select();
  DisjointSets sets(solids);
  for (const BOPTools_BoxPairSelector::PairIDs& pair : selector.Pairs())
  {
    sets.join(pair.ID1, pair.ID2);
  }
  std::map<Index, SolidGroup> groups; // by the first solid
  for (int s = 0; s < solids; ++s)
  {
    groups[sets.find(s)].push_back(static_cast<std::size_t>(s));
  }
  std::vector<SolidGroup> several;
  for (auto& [first, group] : groups)
  {
    if (group.size() > 1)
    {
      several.push_back(std::move(group));
    }
  }
  return several;
}

/// By group, the rows of the labels of its faces.
std::vector<std::vector<std::size_t>> labelsOf(
  const CADModel& model, const std::vector<SolidGroup>& groups)
{
  NCollection_DataMap<TopoDS_Shape, std::size_t, TopTools_ShapeMapHasher> groupOfFace;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    for (const std::size_t s : groups[g])
    {
      for (TopExp_Explorer face(model.solids[s].shape, TopAbs_FACE); face.More(); face.Next())
      {
        groupOfFace.Bind(face.Current(), g);
      }
    }
  }
  std::vector<std::vector<std::size_t>> rows(groups.size());
  for (std::size_t row = 0; row < model.labels.size(); ++row)
  {
    if (const std::size_t* const group = groupOfFace.Seek(model.labels[row].face))
    {
      rows[*group].push_back(row);
    }
  }
  return rows;
}

/// Imprints the solids of a group on each other, or complains and leaves them.
void imprintGroup(CADModel& model, const SolidGroup& group, double tolerance,
  const std::vector<std::size_t>& labels, LabelImages& images, const Progress& progress)
{
  const auto complain = [&](const SolidGroup& solids, const std::string& why) {
    model.complaints.push_back(listWords(namesOf(model, solids)) + " " + why +
      " They are not imprinted on what they touch, and share no faces with it. Switch "
      "ImprintAndMerge off to be rid of this message.");
  };
  BOPAlgo_Builder fuse;
  for (const std::size_t s : group)
  {
    fuse.AddArgument(model.solids[s].shape);
  }
  fuse.SetNonDestructive(true);
  fuse.SetRunParallel(false);
  fuse.SetFuzzyValue(tolerance);
  const opencascade::handle<CADProgress> shown = new CADProgress(progress);
  try
  {
    fuse.Perform(shown->Start());
    shown->check();
    if (fuse.HasErrors())
    {
      complain(group, "cannot be imprinted on each other by the CAD kernel.");
      return;
    }
    const SolidGroup common = overlapping(fuse, model, group);
    if (!common.empty())
    {
      complain(common, "overlap. Mend this in the CAD system.");
      return;
    }
    for (const std::size_t row : labels)
    {
      const CADFaceLabel label = model.labels[row];
      images[row].clear();
      for (const TopoDS_Shape& image : imagesOf(fuse, label.face))
      {
        images[row].push_back({ image, label.name, label.color });
      }
    }
    for (const std::size_t s : group)
    {
      model.solids[s].shape = imagesOf(fuse, model.solids[s].shape).front();
    }
  }
  catch (const Standard_Failure& failure)
  {
    complain(group, "cannot be imprinted: " + describeFailure(failure) + ".");
  }
}
}

void imprintAndMerge(CADModel& model, double tolerance, const Progress& progress)
{
  const SilencedCAD silenced;
  const std::vector<SolidGroup> groups =
    callCAD("boxes of the solids", [&] { return neighbours(model, tolerance * model.size); });
  const std::vector<std::vector<std::size_t>> rows = labelsOf(model, groups);
  LabelImages images;
  for (const CADFaceLabel& label : model.labels)
  {
    images.push_back({ label });
  }
  double all = 0.0;
  for (const SolidGroup& group : groups)
  {
    all += static_cast<double>(group.size());
  }
  double done = 0.0;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    const double next = done + static_cast<double>(groups[g].size());
    imprintGroup(model, groups[g], tolerance * model.size, rows[g], images,
      progressPart(progress, done / all, next / all));
    done = next;
  }
  model.labels.clear();
  for (const std::vector<CADFaceLabel>& pieces : images)
  {
    model.labels.insert(model.labels.end(), pieces.begin(), pieces.end());
  }
}
}
