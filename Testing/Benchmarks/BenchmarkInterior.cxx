// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra by vtkCageHexInterior, from its three inputs to the finished grid, and by gmsh from
// Debian, which extrudes the same quads into as many layers. Both start from a disk with two holes
// that gmsh has meshed.
#include "Interleaved.h"

#include <vtkCageHexInterior.h>

#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

struct Size
{
  double elementSize;
  int layers;
};

// Layers grow with the cube root of the number of hexahedra.
constexpr Size Million{ 0.0195, 100 };
constexpr Size TenMillion{ 0.0091, 215 };

constexpr double Height = 1.8;

std::string geometry(const Size& size, bool extrude)
{
  std::ostringstream text;
  const auto circle = [&](int first, double x, double y, double radius) {
    const double corners[5][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
    for (int i = 0; i < 5; ++i)
    {
      text << "Point(" << first + i << ") = {" << x + radius * corners[i][0] << ", "
           << y + radius * corners[i][1] << ", 0, " << size.elementSize << "};\n";
    }
    for (int i = 1; i < 5; ++i)
    {
      text << "Circle(" << first + i << ") = {" << first + i << ", " << first << ", "
           << first + i % 4 + 1 << "};\n";
    }
    text << "Line Loop(" << first << ") = {" << first + 1 << ", " << first + 2 << ", " << first + 3
         << ", " << first + 4 << "};\n";
  };
  circle(10, 0, 0, 1);
  circle(20, -0.45, 0, 0.2);
  circle(30, 0.45, 0.1, 0.2);
  text << "Plane Surface(1) = {10, 20, 30};\nRecombine Surface{1};\n";
  if (extrude)
  {
    text << "Extrude {0, 0, " << Height << "} { Surface{1}; Layers{" << size.layers
         << "}; Recombine; }\n";
  }
  return text.str();
}

std::string temporaryFile(const std::string& end)
{
  const char* folder = std::getenv("TMPDIR");
  return std::string(folder ? folder : "/tmp") + "/hexsweep-benchmark-" + std::to_string(getpid()) +
    end;
}

/// Runs gmsh; returns what it printed.
std::string runGmsh(const Size& size, bool extrude, const std::string& mesh)
{
  const std::string file = temporaryFile(".geo");
  std::ofstream(file) << geometry(size, extrude);
  const std::string command = "gmsh " + file + (extrude ? " -3" : " -2") + " -nt 1 " +
    (mesh.empty() ? "-save_all -o /dev/null -format msh2" : "-format msh2 -o " + mesh) + " 2>&1";
  std::string output;
  if (FILE* pipe = popen(command.c_str(), "r"))
  {
    std::array<char, 4096> buffer;
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe))
    {
      output += buffer.data();
    }
    pclose(pipe);
  }
  std::remove(file.c_str());
  return output;
}

/// CPU seconds of gmsh's three-dimensional part, as it reports them.
double gmshSeconds(const Size& size)
{
  const std::string output = runGmsh(size, true, "");
  const std::size_t line = output.find("Done meshing 3D");
  const std::size_t cpu = output.find("CPU ", line);
  if (line == std::string::npos || cpu == std::string::npos)
  {
    throw std::runtime_error("gmsh (Debian: gmsh) does not run: " + output.substr(0, 500));
  }
  return std::stod(output.substr(cpu + 4));
}

struct Quads
{
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<vtkIdType, 4>> quads;
};

Quads disk(const Size& size)
{
  const std::string file = temporaryFile(".msh");
  const std::string output = runGmsh(size, false, file);
  std::ifstream stream(file);
  std::remove(file.c_str());
  Quads disk;
  std::map<int, vtkIdType> ids;
  std::string word;
  while (stream >> word && word != "$Nodes")
  {
  }
  std::size_t count = 0;
  stream >> count;
  std::vector<std::array<double, 2>> nodes(count);
  std::map<int, std::size_t> nodeOf;
  for (std::size_t i = 0; i < count; ++i)
  {
    int tag = 0;
    double z = 0.0;
    stream >> tag >> nodes[i][0] >> nodes[i][1] >> z;
    nodeOf[tag] = i;
  }
  while (stream >> word && word != "$Elements")
  {
  }
  stream >> count;
  for (std::size_t e = 0; e < count; ++e)
  {
    int number = 0;
    int type = 0;
    int tags = 0;
    stream >> number >> type >> tags;
    for (int ignored = 0; tags > 0; --tags)
    {
      stream >> ignored;
    }
    constexpr int corners[16] = { 0, 2, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
    std::array<vtkIdType, 4> quad{};
    for (int c = 0; c < corners[type]; ++c)
    {
      int tag = 0;
      stream >> tag;
      if (type == 3)
      {
        const auto known = ids.emplace(tag, static_cast<vtkIdType>(disk.points.size()));
        if (known.second)
        {
          disk.points.push_back(nodes[nodeOf.at(tag)]);
        }
        quad[static_cast<std::size_t>(c)] = known.first->second;
      }
    }
    if (type == 3)
    {
      disk.quads.push_back(quad);
    }
  }
  if (disk.quads.empty())
  {
    throw std::runtime_error("gmsh (Debian: gmsh) does not run: " + output.substr(0, 500));
  }
  return disk;
}

/// A bent and twisted volume whose rings are no affine images of each other.
std::array<double, 3> moved(const std::array<double, 2>& point, double t)
{
  const double pi = std::acos(-1.0);
  const double wave = std::sin(pi * t);
  const double x = point[0] + 0.08 * wave * std::sin(2.0 * point[0] + point[1]);
  const double y = point[1] + 0.06 * wave * std::cos(3.0 * point[0]) * point[1];
  const double c = std::cos(0.6 * t);
  const double s = std::sin(0.6 * t);
  return { c * x - s * y + 0.3 * wave, s * x + c * y + 0.2 * t * t, Height * (t + 0.1 * wave * x) };
}

Grid quadGrid(vtkPoints* points, const std::vector<std::array<vtkIdType, 4>>& quads)
{
  auto grid = Grid::New();
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(quads.size()));
  for (const auto& quad : quads)
  {
    grid->InsertNextCell(VTK_QUAD, 4, quad.data());
  }
  return grid;
}

Grid layer(const Quads& disk, double t)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : disk.points)
  {
    points->InsertNextPoint(moved(point, t).data());
  }
  return quadGrid(points, disk.quads);
}

Grid linkingSides(const Quads& disk, int layers)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (const auto& quad : disk.quads)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const auto ends = std::minmax(quad[c], quad[(c + 1) % 4]);
      ++edges[{ ends.first, ends.second }];
    }
  }
  std::map<vtkIdType, vtkIdType> column;
  std::vector<vtkIdType> nodes;
  for (const auto& edge : edges)
  {
    for (const vtkIdType end : { edge.first.first, edge.first.second })
    {
      if (edge.second == 1 && column.emplace(end, nodes.size()).second)
      {
        nodes.push_back(end);
      }
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k <= layers; ++k)
  {
    for (const vtkIdType node : nodes)
    {
      points->InsertNextPoint(
        moved(disk.points[static_cast<std::size_t>(node)], static_cast<double>(k) / layers).data());
    }
  }
  const vtkIdType ring = static_cast<vtkIdType>(nodes.size());
  std::vector<std::array<vtkIdType, 4>> quads;
  for (const auto& edge : edges)
  {
    for (int k = 0; k < layers && edge.second == 1; ++k)
    {
      const vtkIdType a = column.at(edge.first.first) + k * ring;
      const vtkIdType b = column.at(edge.first.second) + k * ring;
      quads.push_back({ a, b, b + ring, a + ring });
    }
  }
  return quadGrid(points, quads);
}

struct Sweep
{
  Grid source, target, sides;

  explicit Sweep(const Size& size)
  {
    const Quads quads = disk(size);
    source = layer(quads, 0.0);
    target = layer(quads, 1.0);
    sides = linkingSides(quads, size.layers);
  }

  Grid run() const
  {
    vtkNew<vtkCageHexInterior> filter;
    filter->SetMethodToBlend();
    filter->SetCertify(false);
    filter->SetEnsureValid(false);
    filter->SetSourceQuadsData(this->source);
    filter->SetTargetQuadsData(this->target);
    filter->SetLinkingSidesData(this->sides);
    filter->Update();
    return filter->GetOutput();
  }
};

double threadSeconds()
{
  rusage usage;
  getrusage(RUSAGE_THREAD, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double residentMegabytes()
{
  std::ifstream stream("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  stream >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Interior and grid against gmsh's three-dimensional part.
void interior(benchmark::State& state, const Size& size, int rounds, bool withGmsh)
{
  const Sweep sweep(size);
  vtkSMPTools::SetBackend("Sequential");
  Grid grid;
  double peak = 0.0;
  std::vector<double> ours;
  std::vector<double> gmsh;
  for (auto iteration : state)
  {
    (void)iteration;
    for (int round = 0; round < rounds; ++round)
    {
      grid = nullptr;
      const double before = residentMegabytes();
      test::resetPeakMemory();
      const double begin = test::cpuSeconds();
      grid = sweep.run();
      ours.push_back(test::cpuSeconds() - begin);
      peak = std::max(peak, test::peakMegabytes() - before);
      if (withGmsh)
      {
        gmsh.push_back(gmshSeconds(size));
      }
    }
  }
  state.counters["hexes"] = static_cast<double>(grid->GetNumberOfCells());
  state.counters["ours_s"] = median(ours);
  state.counters["memory_over_grid"] =
    peak / (static_cast<double>(grid->GetActualMemorySize()) / 1024.0);
  if (withGmsh)
  {
    state.counters["gmsh_s"] = median(gmsh);
    state.counters["gmsh/ours"] = median(gmsh) / median(ours);
  }
  vtkFieldData* report = grid->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(report->GetAbstractArray("SweepReportStages"));
  vtkDataArray* seconds = report->GetArray("SweepReportSeconds");
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    state.counters["wall_" + names->GetValue(i)] = seconds->GetTuple1(i);
  }
  state.counters["inverted"] = report->GetArray("SweepReportInverted")->GetTuple1(0);
}

/// The same with two threads: the bits, and how much of the work they share.
void twoThreads(benchmark::State& state, const Size& size)
{
  const Sweep sweep(size);
  for (auto iteration : state)
  {
    (void)iteration;
    std::vector<double> alone;
    std::vector<double> largest;
    bool same = true;
    for (int round = 0; round < 5; ++round)
    {
      vtkSMPTools::SetBackend("Sequential");
      double begin = test::cpuSeconds();
      const Grid one = sweep.run();
      alone.push_back(test::cpuSeconds() - begin);
      vtkSMPTools::SetBackend("STDThread");
      vtkSMPTools::Initialize(2);
      begin = test::cpuSeconds();
      const double ownBegin = threadSeconds();
      const Grid two = sweep.run();
      const double own = threadSeconds() - ownBegin;
      // This thread waits while two others work; they take pieces in turn.
      largest.push_back(own + 0.5 * (test::cpuSeconds() - begin - own));
      const std::size_t bytes = static_cast<std::size_t>(one->GetNumberOfPoints()) * 24;
      same = same &&
        std::memcmp(
          one->GetPoints()->GetVoidPointer(0), two->GetPoints()->GetVoidPointer(0), bytes) == 0;
    }
    vtkSMPTools::SetBackend("Sequential");
    state.counters["one_thread_s"] = median(alone);
    state.counters["largest_of_two/one"] = median(largest) / median(alone);
    state.counters["same_bits"] = same;
  }
}
}

BENCHMARK_CAPTURE(interior, Million, Million, 5, true)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(interior, TenMillion, TenMillion, 3, false)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(twoThreads, Million, Million)->Iterations(1)->Unit(benchmark::kSecond);
