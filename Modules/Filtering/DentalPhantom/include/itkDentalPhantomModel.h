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
#ifndef itkDentalPhantomModel_h
#define itkDentalPhantomModel_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomParameters.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace itk
{
/** \class DentalPhantomModel
 * \brief The solid crowns and the gingiva behind a phantom, and the meshes that a scanner would make of them.
 *
 * Each crown is an implicit body in a frame of its own (mesial, buccal, occlusal): squircle sections whose widths
 * change with height, cut by an occlusal surface of cusps; the gingiva is a ridge along the arch. A jaw's mesh is a
 * grid of rays that fan out from a curve inside the ridge and stop where they leave the solid, so that it is a
 * manifold open shell by construction and shows undercuts that the curve can see. The lower crowns are moved
 * vertically until each touches the upper jaw. All results are in the anatomical frame: x anterior, y patient's left,
 * z superior, mm. Free of ITK headers; the same bits for any number of threads.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomModel
{
public:
  using PointType = std::array<double, 3>;

  /** Called from one thread with the fraction done; may throw to abort. */
  using ProgressType = std::function<void(double)>;
  /** A named point, mm in the frame of the model. */
  struct Landmark
  {
    std::string name;
    PointType   point;
  };
  /** One jaw as a mesh. */
  struct JawSurface
  {
    TriangleSurface surface;
    /** FDI number at each point, 0 = gingiva. */
    std::vector<std::uint8_t> labels;
    /** Names as in formats.md, "UR1_tip"; each point is a vertex of the surface. */
    std::vector<Landmark> landmarks;
  };

  /** Throws std::invalid_argument where DentalPhantomParameters::Validate() does. */
  explicit DentalPhantomModel(const DentalPhantomParameters & parameters, unsigned int threads = 0);

  /** The mesh of a jaw: 0 upper, 1 lower. */
  JawSurface
  MakeJaw(unsigned int jaw, unsigned int threads = 0, const ProgressType & progress = {}) const;

  const DentalPhantomParameters &
  GetParameters() const
  {
    return m_Parameters;
  }

  /** How far a tooth of the lower jaw was moved upward to touch the upper jaw, mm; index as in DentalPhantomJaw. */
  double
  GetSettlement(unsigned int tooth) const
  {
    return m_Settlement[tooth];
  }

  /** Whether the tooth exists. */
  bool
  HasTooth(unsigned int jaw, unsigned int tooth) const
  {
    return !m_Parameters.jaws[jaw].teeth[tooth].missing;
  }

  /** Where a ray runs through a tooth, root included: lengths in mm of enamel-covered crown and of root. */
  std::array<double, 2>
  RayThroughTooth(unsigned int jaw, unsigned int tooth, const PointType & origin, const PointType & direction) const;

  /** Centre and radius of a sphere around a tooth with its root. */
  PointType
  GetToothCentre(unsigned int jaw, unsigned int tooth) const;
  double
  GetToothRadius(unsigned int jaw, unsigned int tooth) const;

  /** Unit vector of the tooth's buccal direction in the anatomical frame. */
  PointType
  GetBuccalDirection(unsigned int jaw, unsigned int tooth) const;

  /** A point of the anatomical frame in the tooth's own: mesial, buccal, occlusal from the cervix, mm. */
  PointType
  TransformToTooth(unsigned int jaw, unsigned int tooth, const PointType & point) const;

  /** FDI number of a tooth by its index in DentalPhantomJaw. */
  static std::uint8_t
  ToothFDI(unsigned int jaw, unsigned int tooth);

private:
  /** A cubic Hermite curve over a few knots. */
  struct Profile
  {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> slope;
    Profile() = default;
    Profile(std::vector<double> xs, std::vector<double> ys);
    double
    operator()(double t) const;
  };
  struct Cusp
  {
    double       x;
    double       y;
    double       height;
    double       slopeX;
    double       slopeY;
    const char * name;
  };
  struct Body
  {
    bool         present{ false };
    unsigned int kind{ 0 };
    double       width{ 0.0 };
    double       depth{ 0.0 };
    double       height{ 0.0 };
    double       rootLength{ 13.0 };
    double       squareness{ 0.4 };
    double       smoothness{ 0.4 };
    double       edge{ 0.0 };
    Profile      mesiodistal;
    Profile      buccal;
    Profile      lingual;
    /** Distal and mesial rounding of an incisal edge. */
    double            cornerDistal{ 0.0 };
    double            cornerMesial{ 0.0 };
    std::vector<Cusp> cusps;
    /** Columns mesial, buccal, occlusal in (x, y, o) of the jaw, o pointing occlusally. */
    double    axes[3][3]{};
    PointType cervix{};
    PointType centre{};
    double    radius{ 0.0 };
    /** Interval of arch length, signed: negative is right. */
    double begin{ 0.0 };
    double end{ 0.0 };

    PointType
    ToLocal(const PointType & p) const;
    PointType
    ToJaw(const PointType & local) const;
    double
    OcclusalHeight(double x, double y) const;
    /** Negative inside. Local coordinates. */
    double
    Evaluate(const PointType & local, bool root) const;
  };
  struct Station
  {
    PointType origin;
    double    normal[2];
    double    buccalExtent;
    double    lingualExtent;
    double    crest;
    double    buccalFlange;
    double    lingualFlange;
    int       near[6];
    int       numberOfNear;
  };
  struct Jaw
  {
    /** Left half of the arch at steps of ArchStep, and its outward normals. */
    std::vector<std::array<double, 2>> curve;
    std::vector<std::array<double, 2>> normals;
    std::array<Body, 14>               bodies;
  };

  void
  MakeArch();
  void
  PlaceTeeth(unsigned int jaw);
  void
  Settle(unsigned int threads);
  void
  ArchPoint(unsigned int jaw, double s, double point[2], double normal[2]) const;
  double
  HalfLength(unsigned int jaw, unsigned int side) const;
  Station
  MakeStation(unsigned int jaw, double s) const;
  double
  Gingiva(unsigned int jaw, const Station & station, double q, double o) const;
  JawSurface
  MakeJaw(unsigned int         jaw,
          std::uint32_t        numberOfTriangles,
          bool                 finish,
          unsigned int         threads,
          const ProgressType & progress) const;
  void
  AddLandmarks(unsigned int jaw, JawSurface & result) const;

  DentalPhantomParameters m_Parameters;
  std::array<Jaw, 2>      m_Jaws;
  std::array<double, 14>  m_Settlement{};
};
} // namespace itk

#endif
