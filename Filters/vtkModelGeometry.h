// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkModelGeometry
 * @brief The true surfaces of a solid, which travel with its triangles.
 *
 * A reader that knows the surfaces, such as vtkCADReader, hangs an object of this kind on each
 * solid that it puts out, under the key MODEL_GEOMETRY() of the data object's information, and
 * writes into the solid's field data what it takes to make the object again. vtkOneToOneSweep then
 * puts the nodes of its meshes on these surfaces, see vtkOneToOneSweep::SetSnapToGeometry().
 */
#ifndef vtkModelGeometry_h
#define vtkModelGeometry_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the geometry of a data object

#include <functional> // For the maker
#include <memory>     // For the geometry
#include <mutex>      // For the geometry
#include <string>     // For problems

class vtkDataObject;
class vtkInformationObjectBaseKey;

namespace hexsweep
{
class ModelGeometry;
}

class VTKFILTERSHEXSWEEP_EXPORT vtkModelGeometry : public vtkObject
{
public:
  static vtkModelGeometry* New();
  vtkTypeMacro(vtkModelGeometry, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Key of a data object's information.
  static vtkInformationObjectBaseKey* MODEL_GEOMETRY();

#ifndef __VTK_WRAP__
  using Geometry = std::shared_ptr<const hexsweep::ModelGeometry>;

  /// Makes the geometry, or says why it cannot.
  using Maker = std::function<Geometry(std::string& problem)>;

  /// How the geometry is made when it is first asked for: most solids of a file are never swept.
  void SetMaker(Maker maker);

  /// The geometry; nothing, with the problem, where it cannot be made. May be called by any thread.
  Geometry GetGeometry(std::string& problem);

  /**
   * The geometry of a data object: that in its information, else one that is made from its field
   * data. Nothing where there is neither.
   *
   * @param problem why there are field data of a geometry and it cannot be had from them.
   */
  static Geometry Of(vtkDataObject* data, std::string& problem);

  /// Makes a geometry from field data, or says why it cannot; does neither where there is none.
  using Restorer = Geometry (*)(vtkDataObject* data, std::string& problem);

  /// Called by the library that can restore geometries, when it is loaded.
  static void SetRestorer(Restorer restorer);
#endif

protected:
  vtkModelGeometry();
  ~vtkModelGeometry() override;

private:
  vtkModelGeometry(const vtkModelGeometry&) = delete;
  void operator=(const vtkModelGeometry&) = delete;

  std::mutex Making;
  Maker Make; // empty: it was made
  std::shared_ptr<const hexsweep::ModelGeometry> Model;
  std::string Problem;
};

#endif
