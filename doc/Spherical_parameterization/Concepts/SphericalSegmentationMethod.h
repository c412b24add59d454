/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// A method of `CGAL::Spherical_parameterization::segmentation_from_area_stretch()`: a struct that has the options of the
/// method as public members with defaults.
///
/// This is a closed concept: the models are those below, and programs cannot add models.
///
/// \cgalRefines{`CGAL::Spherical_parameterization::Segment_limits`\, from which it is derived}
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Spherical_parameterization::Majority_vote`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Girth_profiles`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Region_growing`}
/// \cgalHasModelsEnd
class SphericalSegmentationMethod {};
