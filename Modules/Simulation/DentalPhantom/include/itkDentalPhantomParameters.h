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
#ifndef itkDentalPhantomParameters_h
#define itkDentalPhantomParameters_h

#include "DentalPhantomExport.h"

#include <array>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>

namespace itk
{
/** \struct DentalPhantomTooth
 * \brief Size, place and condition of one tooth. Lengths in mm, angles in radians.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantomTooth
{
  bool   missing{ false };    /**< The tooth is not there. */
  double mesiodistal{ 8.0 };  /**< Crown width along the arch. */
  double buccolingual{ 8.0 }; /**< Crown depth across the arch. */
  /** From the cervical line to the incisal edge or the highest cusp. */
  double height{ 8.0 };
  /** About the tooth's long axis. */
  double rotation{ 0.0 };
  /** Mesial crown tip, in the tooth's mesiodistal plane. */
  double tip{ 0.0 };
  /** Buccal crown torque: positive leans the crown outward. */
  double torque{ 0.0 };
  /** Off the arch line; positive is buccal. */
  double buccalOffset{ 0.0 };
  /** Positive moves the crown out of the gingiva. */
  double occlusalOffset{ 0.0 };
  /** Gap to the mesial neighbour; negative is overlap (crowding). */
  double mesialGap{ 0.0 };
  /** A retained milk molar in a premolar's place; it keeps the premolar's number, as public label sets do. */
  bool primary{ false };
  /** What wear has taken off the cusps or the edge. */
  double wear{ 0.0 };
  /** Whether it erupts until it meets its antagonist; an ankylosed or impacted tooth does not. */
  bool settles{ true };
  /** A bracket (a tube on a molar) is bonded to its buccal side. */
  bool bracket{ false };
};

/** \struct DentalPhantomJaw
 * \brief One jaw: fourteen crowns, third molars where there are some, gingiva, trimming. Lengths in mm, angles in
 * radians.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomJaw
{
  /** Indices of all teeth: 0..6 right, 7..13 left, 14 and 15 the right and the left third molar. */
  static constexpr unsigned int NumberOfTeeth = 16;

  DentalPhantomJaw();
  /** Of an index among all teeth. */
  static bool
  IsLeft(unsigned int index)
  {
    return index >= 14 ? index == 15 : index >= 7;
  }
  /** 0 central incisor .. 7 third molar. */
  static unsigned int
  GetPosition(unsigned int index)
  {
    return index >= 14 ? 7 : index % 7;
  }
  static unsigned int
  GetIndex(bool left, unsigned int position)
  {
    return position > 6 ? (left ? 15 : 14) : (left ? 7 : 0) + position;
  }
  DentalPhantomTooth &
  GetTooth(unsigned int index)
  {
    return index < 14 ? teeth[index] : thirdMolars[index - 14];
  }
  const DentalPhantomTooth &
  GetTooth(unsigned int index) const
  {
    return index < 14 ? teeth[index] : thirdMolars[index - 14];
  }

  /** Right 1..7 (central incisor to second molar), then left 1..7. */
  std::array<DentalPhantomTooth, 14> teeth{};
  /** Right, left; missing by default, and then without a place in the arch. */
  std::array<DentalPhantomTooth, 2> thirdMolars{};
  /** What the scan shows behind the second molar, right and left. */
  std::array<double, 2> distalExtension{ { 3.0, 3.0 } };
  /** Height of the gingiva that the scan shows below the cervical line. */
  double buccalFlange{ 6.0 };
  double lingualFlange{ 6.0 };
  /** Oblique trimming of the gingiva: change of the flange per mm toward the front and toward the left. */
  double trimSlopeAnterior{ 0.0 };
  double trimSlopeLeft{ 0.0 };
  /** Wavy border of a scan: amplitude, mm, and phase. */
  double trimWave{ 0.5 };
  double trimPhase{ 0.0 };
  /** A palate (or floor of the mouth) closes the arch. */
  bool   palate{ false };
  double palateDepth{ 13.0 };
};

/** \struct DentalPhantomScan
 * \brief What a scanner and its software add to a jaw or take from it. The number of things of each kind in each jaw.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantomScan
{
  /** Sheets of cheek, lip or floor of the mouth that hang on the border, 5-14 mm wide. */
  std::uint32_t flaps{ 0 };
  /** Loose pieces of tongue or cheek, 3-8 mm in radius. */
  std::uint32_t crumbs{ 0 };
  /** Loose specks of a few triangles. */
  std::uint32_t specks{ 0 };
  std::uint32_t holes{ 0 };
  /** Largest radius of a hole, mm. */
  double holeRadius{ 1.5 };
  /** Quadric decimation to that number of triangles before all that; 0 for none. */
  std::uint32_t decimateTo{ 0 };
  std::uint64_t seed{ 1 };
};

/** \struct DentalPhantomParameters
 * \brief Everything that shapes a pair of phantom jaws. Lengths in mm, angles in radians.
 *
 * A default-constructed set is an average ovoid pair without irregularity; Draw() makes one of a kind for a seed.
 * Crown sizes are the textbook means (Ash, Wheeler's Dental Anatomy).
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomParameters
{
  enum class ArchFamilyEnum : uint8_t
  {
    Tapered,
    Ovoid,
    Square
  };
  /** The frame of the meshes. */
  enum class FrameEnum : uint8_t
  {
    /** x anterior, y patient's left, z superior; both jaws in occlusion. */
    Anatomical,
    /** A random rigid motion of that, the same for both jaws, as a scanner exports them. */
    SharedScanner,
    /** A random rigid motion for each jaw. */
    SeparateScanner,
    /** Each jaw centred at its own centroid, both with the occlusal side toward the same axis, +y or +z, tilted by a
     * few degrees: the upper one lies on its back, as some exports hold them. */
    CentredScanner,
    /** Each jaw centred at its own centroid and upright: superior is +y or +z, tilted by a few degrees. */
    UprightScanner
  };

  /** How irregular Draw() makes a dentition; all are one standard deviation or a probability. */
  struct Variation
  {
    double rotationDegrees{ 5.0 };        /**< Of a tooth about its axis, degrees. */
    double tipDegrees{ 2.0 };             /**< Of a crown along the arch, degrees. */
    double torqueDegrees{ 3.0 };          /**< Of a crown across the arch, degrees. */
    double buccalOffset{ 0.3 };           /**< Of a tooth off the arch line, mm. */
    double occlusalOffset{ 0.15 };        /**< Of a tooth out of the occlusal plane, mm. */
    double spacedArchProbability{ 0.15 }; /**< That there are gaps between all teeth. */
    double palateProbability{ 0.5 };      /**< That the upper scan has the palate. */
    double stoneBaseProbability{ 0.0 };   /**< That scans are those of plaster casts with a base. */
  };

  DentalPhantomParameters();

  /** Arch family, sizes, occlusion, irregularity and trimming for a seed. The scanner frame is SharedScanner. */
  static DentalPhantomParameters
  Draw(std::uint64_t seed, const Variation & variation);
  static DentalPhantomParameters
  Draw(std::uint64_t seed);

  /** A rigid motion p -> rotation p + translation; rotation row-major. */
  struct RigidMotion
  {
    std::array<double, 9> rotation{ { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } }; /**< Row-major. */
    std::array<double, 3> translation{};                                               /**< mm. */
    /** Of a point, mm; and back. */
    std::array<double, 3>
    Apply(const std::array<double, 3> & point) const;
    std::array<double, 3>
    ApplyInverse(const std::array<double, 3> & point) const;
  };

  /** From the anatomical frame to that of a jaw's mesh (0 upper, 1 lower), as frame, frameSeed and, where a frame is
   * centred, frameCentres say. */
  RigidMotion
  ComputeFrame(unsigned int jaw) const;

  /** Every value, a line each, behind an indentation. */
  template <typename TIndent>
  void
  Print(std::ostream & os, const TIndent & indent) const
  {
    std::ostringstream space;
    space << indent;
    this->Write(os, space.str());
  }

  /** Throws std::invalid_argument that names the value where no jaws can be made of it. */
  void
  Validate() const;

  /** Upper, lower. */
  std::array<DentalPhantomJaw, 2> jaws;
  /** Form of both arches. Draw() draws it; the exponent and the coverage below are what the meshes are made by. */
  ArchFamilyEnum archFamily{ ArchFamilyEnum::Ovoid };
  /** Exponent of the arch |y/w|^p + |x/d|^p = 1: 2 is an ellipse, more is squarer. */
  double archExponent{ 2.15 };
  /** How far along a quarter of that curve the second molar ends: smaller is more tapered. */
  double archCoverage{ 1.36 };
  /** Half the upper arch's width between the crown lines at the distal ends of the second molars. */
  double archHalfWidth{ 29.0 };

  double overjet{ 2.5 };  /**< Upper before lower incisors, mm. */
  double overbite{ 2.0 }; /**< Upper over lower incisors, mm. */
  /** Depth of the curve of Spee. */
  double speeDepth{ 1.2 };
  /** Curve of Wilson: factor on the molars' transverse inclination. */
  double wilson{ 1.0 };

  /** A trimmed plaster cast: closed body with a base of this thickness below the deepest gingiva. */
  bool   stoneBase{ false };
  double baseHeight{ 10.0 };

  /** Standard deviation of the scan along its normals. */
  double        scannerNoise{ 0.0 };
  std::uint64_t noiseSeed{ 1 };

  FrameEnum     frame{ FrameEnum::Anatomical }; /**< Of the meshes and the landmarks. */
  std::uint64_t frameSeed{ 1 };                 /**< What a random motion is drawn from. */
  /** What becomes the origin of a centred frame, in the anatomical frame; DentalPhantomMeshSource sets the centroid of
   * each scan's points. */
  std::array<std::array<double, 3>, 2> frameCentres{};
  /** What a scanner and its software add to both jaws or take from them. */
  DentalPhantomScan scan;

  /** Approximate, each jaw (reached within 10 %). */
  std::uint32_t numberOfTriangles{ 60000 };

private:
  RigidMotion
  ComputeCentredFrame(unsigned int jaw) const;
  void
  Write(std::ostream & os, const std::string & indent) const;
};

DentalPhantom_EXPORT std::ostream &
                     operator<<(std::ostream & os, DentalPhantomParameters::ArchFamilyEnum family);
DentalPhantom_EXPORT std::ostream &
                     operator<<(std::ostream & os, DentalPhantomParameters::FrameEnum frame);
} // namespace itk

#endif
