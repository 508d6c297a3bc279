// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The names of all arrays that the filters read and write: the reference of what they mean.
 *
 * Ids are vtkIdType, measures are double, texts are vtkStringArray. n: how many tuples.
 */
#ifndef HexSweepArrays_h
#define HexSweepArrays_h

namespace hexsweep
{
/// Arrays of points, cells and (the last ones) fields.
namespace arrays
{
// What solids bring.

/// Cells: face of the solid, any whole number type. The first choice where no array is named.
constexpr const char* FaceId = "FaceId";
/// Cells: the same as gmsh writes it, the second choice; of volume cells their volume.
constexpr const char* CellEntityIds = "CellEntityIds";
/// Cells, in and out: the volume.
constexpr const char* VolumeId = "VolumeId";
/// Field, texts, one a face id from 0 on: the face's name, empty where it has none.
constexpr const char* FaceNames = "FaceNames";
/// Field, n = 1, text: the volume's name in a file.
constexpr const char* VolumeName = "VolumeName";
/// Field, text: the name of volume i is value i, where there are several; empty where it has none.
constexpr const char* VolumeNames = "VolumeNames";
/// Field, 3 components in [0, 1]: red, green, blue of face i; negative where it has none.
constexpr const char* FaceColors = "FaceColors";
/// Field, n = 1, text: unit of the coordinates, as "millimetre".
constexpr const char* LengthUnit = "LengthUnit";

// Solids of vtkCADReader: the true geometry, not handed on to meshes.

/// Field, unsigned char: the solid in OpenCASCADE's binary format, which keeps every bit.
constexpr const char* CADGeometry = "CADGeometry";
/// Fields, one a face and an edge of that: their ids, 0 for edges without length.
constexpr const char* CADFaceIds = "CADFaceIds";
constexpr const char* CADEdgeIds = "CADEdgeIds";
/// Fields, in place of CADGeometry where that would be large: file (text), its checksum (text), the
/// reader's settings (text), number of the solid.
constexpr const char* CADFile = "CADFile";
constexpr const char* CADChecksum = "CADChecksum";
constexpr const char* CADSettings = "CADSettings";
constexpr const char* CADSolid = "CADSolid";
/// Cells of CAD edges: edge of the model, and the faces of the solid on its two sides (the same
/// twice along a seam).
constexpr const char* EdgeId = "EdgeId";
constexpr const char* EdgeFaceIds = "EdgeFaceIds";

// Hexahedra and linking sides.

/// Points: point of the source quads that the column begins at.
constexpr const char* SourcePointIds = "SourcePointIds";
/// Cells of hexahedra: source quad that the column begins at.
constexpr const char* SourceCellIds = "SourceCellIds";
/// Points: 0 (source) ... L (target); cells: 0 ... L - 1.
constexpr const char* SweepLayer = "SweepLayer";
/// Cells of linking sides: loop of the source quads.
constexpr const char* LoopId = "LoopId";

// The boundary of hexahedra.

/// Points: point of the hexahedra.
constexpr const char* HexPointIds = "HexPointIds";
/// Cells: face of the solid; of linking sides, too.
constexpr const char* BoundaryId = "BoundaryId";
/// Cells, unsigned char: 0 source, 1 target, 2 side.
constexpr const char* BoundaryPart = "BoundaryPart";
/// Cells: the hexahedron behind the quad.
constexpr const char* HexId = "HexId";
/// Cells: which of its sides, 1 to 6 in the order of Exodus II.
constexpr const char* HexSide = "HexSide";
/// The same of both sides of a quad in an assembly, two components each: the volumes (0: none), the
/// hexahedra (-1) and their sides (0).
constexpr const char* VolumeIds = "VolumeIds";
constexpr const char* HexIds = "HexIds";
constexpr const char* HexSides = "HexSides";
/// Points, global ids: the same for points that volumes of an assembly share.
constexpr const char* GlobalNodeIds = "GlobalNodeIds";
/// Cells, global ids: of hexahedra of an assembly.
constexpr const char* GlobalCellIds = "GlobalCellIds";

// Side sets and node sets.

/// Field, n = 1, text: the set's name, see vtkSweepSets.
constexpr const char* SetName = "SetName";
/// Field, n = 1: the set's id.
constexpr const char* SetId = "SetId";

// Quality.

/// Cells, in [-1, 1]: least scaled Jacobian of the corners.
constexpr const char* ScaledJacobian = "ScaledJacobian";
/// Cells of hexahedra: proven lower bound of the Jacobian; not a number where nothing is proven.
constexpr const char* JacobianLowerBound = "JacobianLowerBound";
/// Cells of hexahedra, unsigned char: see vtkHexValidity.
constexpr const char* Validity = "Validity";

// Disk maps.

/// Points, 3 components, z = 0: place in the unit disk.
constexpr const char* DiskCoordinates = "DiskCoordinates";
/// Points, 3 components: place on the cap, where the points themselves are in the disk.
constexpr const char* SurfacePoints = "SurfacePoints";
/// Points: point of the input, -1 for those that were added.
constexpr const char* OriginalPointIds = "OriginalPointIds";
/// Cells: cell of the input.
constexpr const char* OriginalCellIds = "OriginalCellIds";
/// Field, n = 1, text: Disk, Annulus or Circles.
constexpr const char* DiskMapDomain = "DiskMapDomain";
/// Field, 3 components, one tuple a hole: centre x, y, radius.
constexpr const char* HoleCircles = "HoleCircles";
}

/// Field arrays that report what a filter did; one value each where nothing else is said.
namespace reports
{
/// What they all begin with.
constexpr const char* Prefix = "SweepReport";

// Every filter.

/// Text: what really ran: the method of projection (vtkSweepQuadProjector), the methods of the
/// interior (vtkCageHexInterior, vtkOneToOneSweep). Of vtkHarmonicDiskMap the same as Weights.
constexpr const char* Method = "SweepReportMethod";
/// Id: vertex and line cells of the (first) input that were left aside.
constexpr const char* IgnoredCells = "SweepReportIgnoredCells";
/// Texts, one a stage of the work.
constexpr const char* Stages = "SweepReportStages";
/// Measures, one a stage: seconds.
constexpr const char* Seconds = "SweepReportSeconds";

// Disk maps (vtkHarmonicDiskMap, and outputs 1 and 2 of vtkSweepQuadProjector).

/// Text: the weights that were used in the end: Cotangent, IntrinsicCotangent or MeanValue.
constexpr const char* Weights = "SweepReportWeights";
/// Id: boundary loops.
constexpr const char* Loops = "SweepReportLoops";
/// Ids: triangles flipped with the wanted weights, and in the result (the projector's: both caps).
constexpr const char* FlipsBefore = "SweepReportFlipsBefore";
constexpr const char* FlipsAfter = "SweepReportFlipsAfter";
/// Ids: what ImproveTriangulation did.
constexpr const char* EdgeFlips = "SweepReportEdgeFlips";
constexpr const char* AddedPoints = "SweepReportAddedPoints";
/// Measure: no less than the area of the image.
constexpr const char* DirichletEnergy = "SweepReportDirichletEnergy";
/// Measures, degrees: at the corners of triangles.
constexpr const char* WorstAngleDistortion = "SweepReportWorstAngleDistortion";
constexpr const char* MeanAngleDistortion = "SweepReportMeanAngleDistortion";
/// Id: rounds of Koebe's iteration.
constexpr const char* KoebeRounds = "SweepReportKoebeRounds";
/// Id: 1 where it came to its tolerance, else 0.
constexpr const char* KoebeConverged = "SweepReportKoebeConverged";
/// Measures, one a round from the second on.
constexpr const char* KoebeChanges = "SweepReportKoebeChanges";
/// Measures, one a loop: how far its image was from a circle, over the radius.
constexpr const char* Circularity = "SweepReportCircularity";
/// Measures, one a loop: where it begins on the partner's loop, as a fraction of that one's length.
constexpr const char* LoopStarts = "SweepReportLoopStarts";

// Quads on the target cap (vtkSweepQuadProjector).

/// Ids: quads with a corner <= 0, in the result and as projected.
constexpr const char* InvertedQuads = "SweepReportInvertedQuads";
constexpr const char* InvertedBefore = "SweepReportInvertedBefore";
/// Id: those of them that no place of the inner nodes can mend.
constexpr const char* FixedInvertedQuads = "SweepReportFixedInvertedQuads";
/// Id: descents of untangling and polishing.
constexpr const char* Rounds = "SweepReportRounds";
/// Measure: of interior nodes from the source surface.
constexpr const char* MaximumSourceDistance = "SweepReportMaximumSourceDistance";
/// Measure: of the middles of the mesh's side quads from the sides of the solid, which quads cut
/// off where no layer follows a ledge, a groove or a curve.
constexpr const char* MaximumSideDistance = "SweepReportMaximumSideDistance";
/// Measure: of the last ring from the boundary of the target surface.
constexpr const char* MaximumBoundaryDistance = "SweepReportMaximumBoundaryDistance";
/// Id: nodes that lay in no triangle of the target's disk map.
constexpr const char* Outside = "SweepReportOutside";
/// Measure, degrees: how far loops turn about each other along the sides, where quads were carried
/// along them.
constexpr const char* Winding = "SweepReportWinding";
/// Measure: at 1 and below the map of PAPER_HARMONIC folds.
constexpr const char* NitscheRatio = "SweepReportNitscheRatio";

// Linking sides (vtkLinkingSideMesher, vtkOneToOneSweep).

/// Id.
constexpr const char* Layers = "SweepReportLayers";
/// Ids: edges of the solid that became columns, and that did not.
constexpr const char* KeptEdges = "SweepReportKeptEdges";
constexpr const char* LostEdges = "SweepReportLostEdges";
/// Measure.
constexpr const char* MeanColumnLength = "SweepReportMeanColumnLength";

// Quality of the cells (quads of the projector, hexahedra of the others).

/// Measures, in [-1, 1].
constexpr const char* MinScaledJacobian = "SweepReportMinScaledJacobian";
constexpr const char* MeanScaledJacobian = "SweepReportMeanScaledJacobian";
/// Measure: what no place of the inner nodes can better.
constexpr const char* FloorScaledJacobian = "SweepReportFloorScaledJacobian";
/// Ids: hexahedra, and how many of them are...
constexpr const char* Hexes = "SweepReportHexes";
constexpr const char* Inverted = "SweepReportInverted";
constexpr const char* InvertedInside = "SweepReportInvertedInside";
constexpr const char* Degenerate = "SweepReportDegenerate";
constexpr const char* Undecided = "SweepReportUndecided";
constexpr const char* NotCertified = "SweepReportNotCertified";
/// Measure: the least JacobianLowerBound.
constexpr const char* MinJacobianLowerBound = "SweepReportMinJacobianLowerBound";

// The interior (vtkCageHexInterior, vtkOneToOneSweep).

/// Texts, one a step of the cascade.
constexpr const char* Steps = "SweepReportSteps";
/// Ids, one a step: hexahedra that are not certified after it, and how many fewer than before it.
constexpr const char* StepNotCertified = "SweepReportStepNotCertified";
constexpr const char* StepMended = "SweepReportStepMended";
/// Id: hexahedra that caps and linking sides alone make bad.
constexpr const char* CornerConflicts = "SweepReportCornerConflicts";

// Solids (vtkOneToOneSweep, vtkSweepCandidates).

/// Ids, one a body: in the order of the other reports, which have the values of one body after
/// those of the other. Only where there are several.
constexpr const char* VolumeIds = "SweepReportVolumeIds";
/// Text: SourceQuads, Solid or made.
constexpr const char* SourceQuads = "SweepReportSourceQuads";
/// Text: how the quads came to the target cap.
constexpr const char* Projection = "SweepReportProjection";
/// Ids, one a face.
constexpr const char* SourceFaceIds = "SweepReportSourceFaceIds";
constexpr const char* TargetFaceIds = "SweepReportTargetFaceIds";
/// Ids of the volumes of an assembly that have no hexahedra; not there where all have.
constexpr const char* UnmeshedVolumes = "SweepReportUnmeshedVolumes";
/// Counts, one a volume of an assembly: pieces that it was cut into, 1 for one that was not.
constexpr const char* Pieces = "SweepReportPieces";
/// Texts, one a volume of an assembly: face ids with blanks between.
constexpr const char* PlannedSources = "SweepReportPlannedSources";
constexpr const char* PlannedTargets = "SweepReportPlannedTargets";
/// Texts, one a way to sweep the solid, best first; not where both caps are named.
constexpr const char* Candidates = "SweepReportCandidates";
/// Id: 1 where there were more pairs of caps than were tried, else 0.
constexpr const char* CandidatesCut = "SweepReportCandidatesCut";
/// Measure: edge length of the hexahedra, asked for or chosen.
constexpr const char* Size = "SweepReportSize";
/// Id: points that were given up for another one.
constexpr const char* MergedPoints = "SweepReportMergedPoints";
/// Triangles of the solid without area, flipped away.
constexpr const char* FlippedTriangles = "SweepReportFlippedTriangles";

// Sweeps between several caps (vtkManyToManySweep).

/// Measures, three a body: unit vector along the sweep.
constexpr const char* SweepDirection = "SweepReportSweepDirection";
/// Measures, three a body: a point and the unit vector of the axis of a sweep round one.
constexpr const char* SweepAxisPoint = "SweepReportSweepAxisPoint";
constexpr const char* SweepAxisDirection = "SweepReportSweepAxisDirection";
/// Id: parts of the plane across the sweep, each with its own caps.
constexpr const char* Regions = "SweepReportRegions";
/// Id: sheets of nodes on which caps lie.
constexpr const char* Levels = "SweepReportLevels";
/// Measure: greatest distance of curves of caps that became one.
constexpr const char* GreatestImprint = "SweepReportGreatestImprint";

// Solids whose boundary nodes may move.

/// Id: boundary nodes that were moved along their faces.
constexpr const char* MovedBoundaryNodes = "SweepReportMovedBoundaryNodes";
/// Measure: the longest way that one of them was moved.
constexpr const char* GreatestBoundaryMove = "SweepReportGreatestBoundaryMove";

// Solids with their true geometry.

/// Ids: boundary nodes that were put on the true surfaces, and those that were left on the facets.
constexpr const char* SnappedNodes = "SweepReportSnappedNodes";
constexpr const char* UnsnappedNodes = "SweepReportUnsnappedNodes";
/// Measure: the longest way that a node was moved for it.
constexpr const char* GreatestSnap = "SweepReportGreatestSnap";

// Faces of solids (vtkSolidFaces).

/// Id: 1 where faces were found by angle, else 0.
constexpr const char* FacesByAngle = "SweepReportFacesByAngle";
}
}

#endif
