// SPDX-License-Identifier: BSD-3-Clause
// The swept mesh of a C section that opens, cut open below the target cap and coloured by
// scaled Jacobian.
#include <vtkActor.h>
#include <vtkCageHexInterior.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetMapper.h>
#include <vtkHexValidity.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRegressionTestImage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSweepQuadProjector.h>
#include <vtkTestUtilities.h>
#include <vtkThreshold.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <string>

namespace
{
void open(vtkXMLUnstructuredGridReader* reader, const std::string& folder, const char* name)
{
  reader->SetFileName((folder + "/" + name + ".vtu").c_str());
}

// Blue for a perfect hex through green and yellow; red at 0.7.
void makeColors(vtkLookupTable* colors)
{
  colors->SetHueRange(0.0, 0.667);
  colors->SetTableRange(0.7, 1.0);
  colors->Build();
}
}

int TestSweepImage(int argc, char* argv[])
{
  const std::string folder = std::string(HEXSWEEP_DATA_DIR) + "/cases/c_open";
  vtkNew<vtkXMLUnstructuredGridReader> sourceQuads, sourceSurface, targetSurface, linkingSides;
  open(sourceQuads, folder, "source_quads");
  open(sourceSurface, folder, "source_surface");
  open(targetSurface, folder, "target_surface");
  open(linkingSides, folder, "linking_quads");

  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetSourceQuadsConnection(sourceQuads->GetOutputPort());
  projector->SetTargetSurfaceConnection(targetSurface->GetOutputPort());
  projector->SetLinkingSidesConnection(linkingSides->GetOutputPort());
  projector->SetSourceSurfaceConnection(sourceSurface->GetOutputPort());
  // The quads as they are projected: optimising them has its own tests.
  projector->EnsureValidOff();
  projector->ImproveQualityOff();
  vtkNew<vtkCageHexInterior> interior;
  interior->SetSourceQuadsConnection(sourceQuads->GetOutputPort());
  interior->SetTargetQuadsConnection(projector->GetOutputPort());
  interior->SetLinkingSidesConnection(linkingSides->GetOutputPort());
  vtkNew<vtkHexValidity> validity;
  validity->SetInputConnection(interior->GetOutputPort());
  validity->Update();

  // Whole layers: a plane would pass next to nodes, where rounding decides what it cuts away.
  auto* layers = vtkDataSet::SafeDownCast(validity->GetOutputDataObject(0))
                   ->GetCellData()
                   ->GetArray("SweepLayer");
  vtkNew<vtkThreshold> below;
  below->SetInputConnection(validity->GetOutputPort());
  below->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "SweepLayer");
  below->SetThresholdFunction(vtkThreshold::THRESHOLD_LOWER);
  below->SetLowerThreshold(0.8 * layers->GetRange()[1]);

  vtkNew<vtkLookupTable> colors;
  makeColors(colors);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(below->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("ScaledJacobian");
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->EdgeVisibilityOn();
  // Mostly flat colour: the picture shall change with the mesh, not with the light.
  actor->GetProperty()->SetAmbient(0.6);
  actor->GetProperty()->SetDiffuse(0.4);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(1.2, 1.2, 1.6);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(500, 400);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  window->Render();

  const int result = vtkRegressionTestImage(window);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    interactor->Start();
  }
  return result == vtkRegressionTester::FAILED ? EXIT_FAILURE : EXIT_SUCCESS;
}
