// SPDX-License-Identifier: BSD-3-Clause
// Settings that ask for more than there can be are refused before memory is taken or time is lost.
#include "EveryFilter.h"

#include <vtkHarmonicDiskMap.h>
#include <vtkLinkingSideMesher.h>
#include <vtkManyToManySweep.h>
#include <vtkOneToOneSweep.h>

#include <chrono>
#include <limits>

namespace TestAbsurdSettings
{
using namespace test;

template <typename Filter>
void expectRefused(const std::string& name, const std::function<void(Filter*)>& set,
  const std::vector<std::string>& parts)
{
  const vtkSmartPointer<vtkAlgorithm> filter = filterUse(name).on();
  set(Filter::SafeDownCast(filter));
  Events events(filter);
  const auto begin = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  ASSERT_EQ(events.errors.size(), 1u) << name;
  for (const std::string& part : parts)
  {
    EXPECT_NE(events.errors[0].find(part), std::string::npos) << events.errors[0];
  }
  EXPECT_FALSE(hasOutput(filter));
  EXPECT_LT(took.count(), 5.0);
}

const std::vector<std::string> TooMany = { "hexahedra, which take ",
  " gigabytes: more than there are" };

template <typename Sweep>
void expectSizesRefused(const std::string& name)
{
  for (const double size : { 1e-300, std::numeric_limits<double>::denorm_min(), 1e-20, 1e-10 })
  {
    SCOPED_TRACE(size);
    expectRefused<Sweep>(
      name, [=](Sweep* sweep) { sweep->SetSize(size); }, TooMany);
    expectRefused<Sweep>(
      name, [=](Sweep* sweep) { sweep->SetLayerSize(size); }, TooMany);
  }
  for (const int layers : { 1000000000, std::numeric_limits<int>::max() })
  {
    SCOPED_TRACE(layers);
    expectRefused<Sweep>(
      name, [=](Sweep* sweep) { sweep->SetNumberOfLayers(layers); }, TooMany);
  }
  for (const double size : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    SCOPED_TRACE(size);
    expectRefused<Sweep>(name, [=](Sweep* sweep) { sweep->SetSize(size); }, { "the size is " });
    expectRefused<Sweep>(name, [=](Sweep* sweep) { sweep->SetLayerSize(size); }, { "size is " });
  }
}

TEST(AbsurdSettings, OneToOneSweepRefusesThem)
{
  expectSizesRefused<vtkOneToOneSweep>("OneToOneSweep");
  for (const double size : { 1e-300, 1e-8 })
  {
    expectRefused<vtkOneToOneSweep>(
      "OneToOneSweep", [=](vtkOneToOneSweep* sweep) { sweep->SetQuadSize(size); }, TooMany);
  }
}

TEST(AbsurdSettings, ManyToManySweepRefusesThem)
{
  expectSizesRefused<vtkManyToManySweep>("ManyToManySweep");
}

TEST(AbsurdSettings, LinkingSideMesherRefusesThem)
{
  const std::string name = "LinkingSideMesher";
  using Mesher = vtkLinkingSideMesher;
  expectRefused<Mesher>(
    name, [](Mesher* sides) { sides->SetNumberOfLayers(2147483647); }, TooMany);
  expectRefused<Mesher>(
    name, [](Mesher* sides) { sides->SetLayerSize(1e-300); }, TooMany);
  expectRefused<Mesher>(
    name, [](Mesher* sides) { sides->SetNumberOfLayers(0); }, { "layers is 0" });
  expectRefused<Mesher>(
    name, [](Mesher* sides) { sides->SetGrowthRatio(1e300); }, { "has no thickness" });
}

TEST(AbsurdSettings, ManyIterationsEndWithoutThem)
{
  // Nothing gets nearer than rounding allows, however often it is tried.
  const vtkSmartPointer<vtkAlgorithm> filter = filterUse("HarmonicDiskMap").on();
  auto* map = vtkHarmonicDiskMap::SafeDownCast(filter);
  map->SetTolerance(0.0);
  map->SetMaximumIterations(std::numeric_limits<int>::max());
  const auto begin = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 20.0);
}
}
