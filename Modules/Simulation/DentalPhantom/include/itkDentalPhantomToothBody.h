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
#ifndef itkDentalPhantomToothBody_h
#define itkDentalPhantomToothBody_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomParameters.h"
#include "itkDentalPhantomProfile.h"

#include <array>
#include <vector>

namespace itk
{
/** \struct DentalPhantomToothBody
 * \brief One tooth as an implicit solid in a frame of its own (mesial, buccal, occlusal from the cervix, mm).
 *
 * Squircle sections whose widths change with height, cut by an occlusal surface of cusps. Shape() gives it the form of
 * its kind; DentalPhantomDentition places it.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomToothBody
{
  using PointType = std::array<double, 3>;

  /** A cusp: where its tip stands on the crown, how high, and how steep its sides are; the name of its landmark. */
  struct Cusp
  {
    double       x;      /**< Mesial, mm. */
    double       y;      /**< Buccal, mm. */
    double       height; /**< Of the tip above the cervix, mm. */
    double       slopeX; /**< How much the sides fall per mm along the arch. */
    double       slopeY; /**< How much they fall per mm across the arch. */
    const char * name;   /**< Of its landmark, such as "MB"; null: none. */
  };
  bool present{ false }; /**< Whether the tooth is there. */
  /** Whether the arch has a place for it: a lost tooth leaves one, one that never was does not. */
  bool space{ false };
  /** 0 incisor, 1 canine, 2 premolar, 3 molar. */
  unsigned int kind{ 0 };
  double       width{ 0.0 };
  double       depth{ 0.0 };
  double       height{ 0.0 };
  double       rootLength{ 13.0 };
  double       squareness{ 0.4 };
  double       smoothness{ 0.4 };
  /** Buccal place of an incisal edge. */
  double               edge{ 0.0 };
  DentalPhantomProfile mesiodistal;
  DentalPhantomProfile buccal;
  DentalPhantomProfile lingual;
  /** Distal and mesial rounding of an incisal edge. */
  double            cornerDistal{ 0.0 };
  double            cornerMesial{ 0.0 };
  std::vector<Cusp> cusps;
  /** Taken off the cusps or the edge. */
  double wear{ 0.0 };
  /** The tooth may move to meet its antagonist. */
  bool settles{ true };
  /** Half widths (mesial, buccal, occlusal) of a bracket; no bracket where they are 0. */
  double bracket[3]{};
  /** From the cervix (z 0) down: a bent cone of elliptic sections. */
  struct Root
  {
    double baseX;   /**< Mesial place at the cervix. */
    double baseY;   /**< Buccal place at the cervix. */
    double apexX;   /**< Mesial place of the apex. */
    double apexY;   /**< Buccal place of the apex. */
    double length;  /**< From cervix to apex. */
    double radiusX; /**< Mesial half width at the cervix. */
    double radiusY; /**< Buccal half width at the cervix. */
  };
  std::vector<Root> roots; /**< One to three. */
  /** Where several roots part, below the cervix. */
  double trunk{ 0.0 };
  /** Columns mesial, buccal, occlusal in (x, y, o) of the jaw, o pointing occlusally. */
  double    axes[3][3]{};
  PointType cervix{};
  PointType centre{};
  double    radius{ 0.0 };
  /** Interval of arch length, signed: negative is right. */
  double begin{ 0.0 };
  double end{ 0.0 };

  /** Gives the crown the form of a jaw's (0 upper, 1 lower) tooth at a position (0 central incisor .. 6 second molar)
   * in a tooth's size. */
  void
  Shape(unsigned int jaw, unsigned int position, const DentalPhantomTooth & tooth);

  /** Called by Shape(). */
  void
  ShapePrimaryMolar(unsigned int jaw, unsigned int position);
  void
  ShapeRoots(unsigned int jaw, unsigned int position, bool isPrimary);
  /** From the jaw's frame to the tooth's, and back, mm. */
  PointType
  ToLocal(const PointType & p) const;
  PointType
  ToJaw(const PointType & local) const;
  /** The apex of the longest root, in local coordinates. */
  PointType
  GetApex() const;
  /** Of the occlusal surface over (mesial, buccal), mm from the cervix. */
  double
  OcclusalHeight(double x, double y) const;
  /** Negative inside. Local coordinates. Without its root a crown ends a little below the gingiva's margin. */
  double
  Evaluate(const PointType & local, bool root) const;
  /** The whole tooth with roots of its kind: single, or two or three that part below a trunk. The crown is that of
   * Evaluate(). */
  double
  EvaluateWhole(const PointType & local) const;
  /** Negative in the bracket; a large number where there is none. */
  double
  EvaluateBracket(const PointType & local) const;
};
} // namespace itk

#endif
