/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkCaseResult_h
#define itkCaseResult_h

#include "itkDentalCaseData.h"
#include "itkRegistrationCourse.h"
#include "itkRegistrationFinding.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** How a case is registered. */
enum class CasePresetEnum : uint8_t
{
  Robust,
  Paper,
  BoundingBox,
  SingleStage
};

/** Point-to-point distances between tracing and moving contour, pixels, by the paper's definitions. */
struct ContourFigures
{
  double chamfer{ 0.0 };       /**< Mean of the two directed means. */
  double hausdorff{ 0.0 };     /**< The largest distance of a point of either to the other. */
  double movingToFixed{ 0.0 }; /**< Mean from the silhouette's points to the tracing. */
  double fixedToMoving{ 0.0 }; /**< Mean from the tracing's points to the silhouette. */
};

/** Errors of the predicted against the marked landmarks, pixels; a group without landmarks is absent. */
struct LandmarkFigures
{
  std::size_t                   count{ 0 };               /**< Landmarks that are both marked and predicted. */
  double                        mean{ 0.0 };              /**< Mean distance. */
  double                        rmse{ 0.0 };              /**< Root of the mean squared distance. */
  double                        standardDeviation{ 0.0 }; /**< Of the distances about their mean. */
  std::map<std::string, double> groups; /**< Mean distance a tooth group, by its name in the result file. */
  /** One a landmark (of the middle of two sides where the tracing was bisected). */
  std::vector<std::pair<std::string, double>> landmarks;
  /** How their points were found on the scan, by name, where nobody marked them there: that the points may be elsewhere
   * is in the errors then. */
  std::map<std::string, std::string> sources;
  /** Where each of them was marked and predicted, pixels, in the same order. */
  std::vector<std::array<double, 2>> marked;
  std::vector<std::array<double, 2>> predicted;
};

/** A predicted landmark. */
struct LandmarkPrediction
{
  std::string           name;                     /**< Such as "UR6_MB"; "U6_MB" of a middle of two sides. */
  std::array<double, 2> position{ { 0.0, 0.0 } }; /**< Continuous pixel index, (u, v). */
  /** Row-major 2x2, square pixels; absent where the method has none. */
  std::optional<std::array<double, 4>> covariance;
  /** The same of the middle between this and the other side's landmark, where a tracing was bisected. */
  std::optional<std::array<double, 4>> middleCovariance;

  /** Standard deviation an axis: the root of half the covariance's trace. */
  double
  GetSigma() const;
  double
  GetMiddleSigma() const;
};

/** The middle of a right and a left landmark's images, where that is what was drawn, or where nobody marked the scan.
 */
struct MiddlePrediction
{
  /** Without a side: "U6_MB". */
  std::string           name;
  std::array<double, 2> position{ { 0.0, 0.0 } };
  /** Standard deviation an axis, pixels: of the jaw's place, and of the point's on the scan where it was found by other
   * means than landmarks_3d. */
  double sigma{ 0.0 };
  /** "landmarks_3d", "tooth labels", "its place along the arch", as a landmark that was registered with; beside a
   * tracing "the traced tooth" and "its place on the other side". */
  std::string source;
};

/** A landmark that was registered with. */
struct UsedLandmark
{
  /** CephalometricLandmarkSet::MakeName(). */
  std::string name;
  /** How it was found on the scan: "landmarks_3d". */
  std::string source;
  /** Marked minus predicted, pixels, and in standard deviations. */
  std::array<double, 2> residual{ { 0.0, 0.0 } };
  double                distance{ 0.0 };
  /** What the robust kernel left of it, 1 to 0. */
  double weight{ 1.0 };
};

/** An outline of a whole tooth that was registered with. */
struct UsedOutline
{
  /** "U1", "L6". */
  std::string name;
  /** How far the hand shifted it, as far as can be told: drawn minus predicted, pixels. */
  std::array<double, 2> shift{ { 0.0, 0.0 } };
  /** The same in standard deviations. */
  double shiftDistance{ 0.0 };
  /** Shift, turn and size together, in standard deviations of a shift. */
  double distance{ 0.0 };
  /** What the robust kernel left of it, 1 to 0. */
  double weight{ 1.0 };
  /** Share of its crown's points that lie on the scan's outline. */
  double matchedShare{ 1.0 };
  /** Its shape is another tooth's, as a stock template's is: only tip and axis counted. */
  bool isTemplate{ false };
  /** The outline that it is, moved, turned and scaled: "L6", "UR1 of the stock"; "" where it was not found to be one.
   */
  std::string templateOf;
  /** How far it is from that one, root mean square, mm on the detector. */
  double templateDistance{ 0.0 };
};

/** One of several alignments that fit: a minimum of the method's criterion. */
struct AlignmentCandidate
{
  /** As JawResult::projection. */
  std::array<double, 12> projection{};
  /** How well it fits, lower is better; candidates are ranked by their posterior (PoseCandidate::deviance). */
  double score{ 0.0 };
  /** Root mean square distance of the moving contours from those of the best candidate, pixels of the radiograph. */
  double distance{ 0.0 };
};

/** How far the drawing of one tooth lies from the outline that it was matched with, pixels: over its points that
 * count. */
struct ToothResidual
{
  /** "UR1"; "" where the drawing says none. */
  std::string code;
  std::size_t count{ 0 };
  double      mean{ 0.0 };
  double      rms{ 0.0 };
  double      maximum{ 0.0 };
};

/** What was assumed of one parameter of the pose beforehand, and how far the solution is from it. */
struct ParameterPrior
{
  /** "roll_deg", "yaw_deg", "y_mm", "scale" (logarithm of the factor). */
  std::string name;
  /** Of the solution; the priors' mean is 0. */
  double value{ 0.0 };
  double sigma{ 0.0 };
  /** |value| / sigma: how strongly the prior pulls. */
  double tension{ 0.0 };
};

/** A jaw's pose with its uncertainty: what its points' places on the radiograph, and theirs, are made of. */
struct JawPose
{
  /** Mesh (mm) to the dental frame that the pose is of, row-major 3x4. */
  std::array<double, 12> frame{};
  /** PoseParameters: pitch, roll, yaw (rad), shifts (mm), logarithm of the scale factor. */
  std::array<double, 7> parameters{};
  /** Of these, row-major 7x7. */
  std::array<double, 49> covariance{};
};

/** What is known of one registered jaw. */
struct JawResult
{
  using RowsType = std::array<double, 12>;

  RegistrationStatusEnum status{ RegistrationStatusEnum::Ok }; /**< The verdict: ok, suspect or failed. */
  /** Why it is not ok: of the scan, of the tracing, of the fit. */
  std::vector<RegistrationFinding> findings;
  /** The numbers below mean something only where registered. */
  bool registered{ false };

  /** Mesh file (its unit) to continuous pixel index, homogeneous, row-major 3x4. */
  RowsType             projection{};
  SimilarityParameters similarity;
  /** Mesh (mm) to UMDA frame and to cephalostat frame, row-major 3x4, rigid. */
  RowsType meshToUMDA{};
  RowsType meshToCephalostat{};

  /** Absent where the method knows no pose. */
  std::optional<JawPose> pose;

  /** The first is the one that presets are compared on, "whole". */
  std::vector<std::pair<std::string, ContourFigures>> metrics;
  std::vector<LandmarkPrediction>                     landmarks;
  /** Of every pair of landmarks, where the drawing is of the middle of both sides, and of tips and cusps that were
   * found on the scan where it has none. */
  std::vector<MiddlePrediction> middles;
  /** In the order of their file; empty where only contours were registered. */
  std::vector<UsedLandmark> usedLandmarks;
  /** Outlines of whole teeth that this jaw was registered with. */
  std::vector<UsedOutline> usedOutlines;
  /** "upper" or "lower": the jaw that placed this one, of which nothing was drawn; "" where it has drawings. */
  std::string placedBy;
  /** Only where landmarks were marked in the radiograph. */
  std::optional<LandmarkFigures> error;

  /** Aligned contours to draw and to measure, pixels: name and contour, the first the whole silhouette. */
  std::vector<std::pair<std::string, DentalContour::Pointer>> contours;

  /** The distance of each point of the tracing from the contour that it was matched with, pixels, in the order of the
   * tracing's points; NaN for those of weight 0. Empty where nothing was traced. */
  std::vector<double> tracingDistances;
  /** The same by tooth, in the order of the tracing. */
  std::vector<ToothResidual> residuals;
  /** The outline of the scan that could be matched, else its silhouette, points of the mesh (mm): by a projection they
   * are drawn where the jaw is placed by it. Empty where the method has none. */
  std::vector<std::array<double, 3>> outline;
  /** What the method did, stage by stage; of jaws that share a pose the first has it. */
  std::vector<RegistrationStageCourse> course;
  /** Where the jaw was when each stage began. */
  std::vector<RegistrationStagePlacement> stages;
  /** Of the parameters that have one. */
  std::vector<ParameterPrior> priors;

  /** Distance, pixels, that a landmark's prediction is expected to be off by: the mean over the jaw's landmarks (of the
   * middles where that is what was drawn), without any that at the tracing. Absent where the method has no covariance.
   */
  std::optional<double> expectedError;

  double archWidth{ 0.0 };       /**< mm, from one end of the arch to the other. */
  double archDepth{ 0.0 };       /**< mm, from the front of the arch to its ends. */
  double frameConfidence{ 0.0 }; /**< 0 to 1: how sure the dental frame of the scan is. */

  /** Further numbers of the method, in the order of the result file. */
  std::vector<std::pair<std::string, double>> details;
  /** Best first; empty where the method has none. */
  std::vector<AlignmentCandidate> candidates;
  /** Stage and seconds. */
  std::vector<std::pair<std::string, double>> seconds;

  /** Makes the status at least as bad as the finding; what was said already is not said again. */
  void
  AddFinding(const RegistrationFinding & finding);
  /** The finding of this code is at least so severe. */
  void
  RaiseFinding(const std::string & code, RegistrationStatusEnum severity);
  /** Takes a finding back: the status is that of the others. */
  void
  RemoveFinding(const std::string & code);
  /** Where no number decides. */
  void
  AddFinding(RegistrationStatusEnum severity, const std::string & code, const std::string & text);
  bool
  HasFinding(const std::string & code) const;
  /** The findings' sentences. */
  std::vector<std::string>
  GetReasons() const;
  /** Of the contour of that name; null where it was not measured. */
  const ContourFigures *
  FindMetrics(const std::string & name) const;
};

struct CaseResult;

/** What a further view shows of a registered case. */
struct CaseViewResult
{
  std::string                      name;                                 /**< As the case file calls the view. */
  RegistrationStatusEnum           status{ RegistrationStatusEnum::Ok }; /**< The verdict on the view alone. */
  std::vector<RegistrationFinding> findings;                             /**< Why it is not ok. */
  bool sameHeadPosition{ true }; /**< Whether the head was held as for the lateral radiograph. */
  /** How the head was moved for it, by jaw: pitch, roll, yaw (rad), shifts x, y, z (mm), and standard deviations. */
  std::map<ToothCode::JawEnum, std::array<double, 6>> moves;
  std::map<ToothCode::JawEnum, std::array<double, 6>> moveSigmas;
  /** Factor on the magnification of the view's geometry, by jaw. */
  std::map<ToothCode::JawEnum, double> scaleFactors;
  /** The same case as this view shows it: its radiograph, drawings and geometry are the data's, its jaws' places and
   * landmarks those on this radiograph. It has no verdict of its own. */
  std::shared_ptr<CaseResult> result;
};

/** What a registered case is: all that goes into the output folder. */
struct CaseResult
{
  using JawEnum = ToothCode::JawEnum;

  CasePresetEnum preset{ CasePresetEnum::Paper }; /**< The preset that the result was computed with. */
  /** Of the result of a further view (CaseViewResult); "" of a case. */
  std::string viewName;
  /** NAME=VALUE of what differs from the preset's defaults. */
  std::vector<std::string>              options;
  std::map<JawEnum, JawResult>          jaws;
  std::map<JawEnum, std::string>        skipped;
  std::shared_ptr<const DentalCaseData> data;
  /** Landmarks of the scans that are none: a finding names them, and no error is measured of them. */
  std::vector<std::string> unusableLandmarks;
  /** The files that it is the result of. */
  std::vector<CaseInputFile> inputs;
  /** The words that the program was called with; empty where it was not the program, or where nobody is to know. */
  std::vector<std::string> commandLine;
  /** Nothing in here names a file, a person or a study: MakeAnonymous() made it. */
  bool anonymous{ false };
  /** The marked landmarks, to draw beside the predicted ones; set after registration, null where there are none. */
  DentalLandmarkSet<2>::ConstPointer markedLandmarks;
  /** The geometry as it was used: estimates filled in. */
  CephalometricGeometry::Pointer geometry;
  /** Radiographs beside the lateral one. */
  std::vector<CaseViewResult> views;
  /** Where both jaws are in one frame, mm. */
  bool jawsShareFrame{ false };
  /** What the scans show of it, whatever the case says; empty where there is one jaw. */
  std::string              occlusionFound;
  std::optional<double>    overjet;
  std::optional<double>    overbite;
  std::vector<std::string> warnings;
  /** What the data could not tell. */
  std::vector<std::string> notCheckable;
  double                   totalSeconds{ 0.0 };

  /** The worst of the jaws. */
  RegistrationStatusEnum
  GetStatus() const;
};

const char *
ToString(CasePresetEnum preset);
/** Throws std::invalid_argument that lists the presets. */
CasePresetEnum
CasePresetFromString(const std::string & text);
} // namespace itk

#endif
