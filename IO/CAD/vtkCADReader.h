// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCADReader
 * @brief Reads solids from STEP, IGES and BREP files, ready to be swept.
 *
 * The file is read by OpenCASCADE. What the reader puts out is what sweeping needs, and what VTK's
 * own vtkOCCTReader (VTK 9.3 and later) does not have: face ids that touching solids share, their
 * faces imprinted on each other, the edges with their faces, and the true geometry, so that the
 * nodes of a mesh lie on the surfaces and not on the triangles.
 *
 * Output port 0, `Solids`, a vtkPartitionedDataSetCollection: one partitioned data set a solid, in
 * the order of the file, with one vtkPolyData: triangles that close it, points shared along edges,
 * facing outward. Its name is the solid's. The vtkDataAssembly is the product structure; nodes have
 * the attribute `label` with the name as it stands in the file.
 * - Cells: `FaceId`, unique in the file from 1 on; a face that two solids share has one id.
 * - Field data: `FaceNames` and `FaceColors` by face id, `VolumeName`, `LengthUnit`, and the
 *   geometry (`CADGeometry`, `CADFaceIds`, `CADEdgeIds`; of files whose solids take over 64 MB, in
 *   place of the first `CADFile`, `CADChecksum`, `CADSettings`, `CADSolid`), so that it is still
 *   there when the output is saved and read again. See vtkModelGeometry.
 *
 * Output port 1, `Edges`, likewise one data set a solid: its CAD edges as polylines, with the cell
 * arrays `EdgeId` (unique in the file, from 1 on) and `EdgeFaceIds` (the two faces beside it).
 *
 * Sheet bodies and wires are left out with a warning that counts them. A file that cannot be read,
 * is cut short or has no solid is an error. Reading stops where it is aborted, but for the parsing
 * of the file by the kernel, which cannot be stopped. On several ranks the first one reads; the
 * others have the same structure with nothing in it.
 */
#ifndef vtkCADReader_h
#define vtkCADReader_h

#include "vtkIOHexSweepCADModule.h" // For export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <string> // For the file name

class VTKIOHEXSWEEPCAD_EXPORT vtkCADReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkCADReader* New();
  vtkTypeMacro(vtkCADReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file: .step, .stp, .iges, .igs, .brep or .brp.
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  /// Whether the name of a file is one that is read here.
  static bool CanReadFile(const char* fileName);

  enum LengthUnitType
  {
    FILE_UNIT = 0,
    MILLIMETRE = 1,
    CENTIMETRE = 2,
    METRE = 3,
    KILOMETRE = 4,
    MICROMETRE = 5,
    INCH = 6,
    FOOT = 7,
    MILE = 8
  };

  ///@{
  /// The unit of the coordinates. FILE_UNIT (0, the default): the one that the file names first. Of
  /// BREP files, which name none, coordinates are taken as they are.
  vtkSetMacro(LengthUnit, int);
  vtkGetMacro(LengthUnit, int);
  ///@}

  ///@{
  /// Greatest distance of triangles and lines from the true surfaces, relative to the size of all
  /// solids (the diagonal of the box around them), in [1e-7, 0.1]. 1e-3 by default. When a solid is
  /// swept its surfaces are divided anew, as finely as the size of the hexahedra asks for.
  vtkSetClampMacro(LinearDeflection, double, 1e-7, 0.1);
  vtkGetMacro(LinearDeflection, double);
  ///@}

  ///@{
  /// Greatest turn from one facet of a curve to the next, degrees, in [0.5, 90]. 12 by default.
  vtkSetClampMacro(AngularDeflection, double, 0.5, 90.0);
  vtkGetMacro(AngularDeflection, double);
  ///@}

  ///@{
  /// Where the file has several solids: divide their faces along each other's borders where they
  /// touch, and make one face of two, so that they share face ids. On by default. Solids that
  /// overlap stay as they are, with a warning.
  vtkSetMacro(ImprintAndMerge, bool);
  vtkGetMacro(ImprintAndMerge, bool);
  vtkBooleanMacro(ImprintAndMerge, bool);
  ///@}

  ///@{
  /// Solids nearer than this touch; relative to the size of all solids, in [0, 0.01]. 1e-6 by
  /// default.
  vtkSetClampMacro(ImprintTolerance, double, 0.0, 0.01);
  vtkGetMacro(ImprintTolerance, double);
  ///@}

  ///@{
  /// Repair solids (ShapeFix); a warning says which. Off by default: what STEP files need is done
  /// when they are read.
  vtkSetMacro(HealGeometry, bool);
  vtkGetMacro(HealGeometry, bool);
  vtkBooleanMacro(HealGeometry, bool);
  ///@}

protected:
  vtkCADReader();
  ~vtkCADReader() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkCADReader(const vtkCADReader&) = delete;
  void operator=(const vtkCADReader&) = delete;

  void Execute(vtkInformationVector* outputs);

  std::string FileName;
  int LengthUnit = FILE_UNIT;
  double LinearDeflection = 1e-3;
  double AngularDeflection = 12.0;
  bool ImprintAndMerge = true;
  double ImprintTolerance = 1e-6;
  bool HealGeometry = false;
};

#endif
