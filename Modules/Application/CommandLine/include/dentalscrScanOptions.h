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
#ifndef dentalscrScanOptions_h
#define dentalscrScanOptions_h

#include "CommandLineExport.h"

#include "itkDentalCaseData.h"
#include "itkScanCheckFilter.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace dentalscr
{
/** \class ScanOptions
 * \brief Scans and imaging geometry by a case file or one by one: shared by the verbs that need no tracing. */
class CommandLine_EXPORT ScanOptions
{
public:
  void
  AddTo(CLI::App * command, bool withGeometry); /**< To a verb; those of the geometry where it is asked for. */

  /** Reads the scans (mm) and settles the geometry; without a spacing it has none. Throws DentalInputError. */
  std::shared_ptr<itk::DentalCaseData>
  Load() const;

private:
  std::string         m_CaseFile;
  std::string         m_Upper;
  std::string         m_Lower;
  std::string         m_MeshUnit;
  std::string         m_Occlusion;
  std::vector<double> m_PixelSpacing;
  std::string         m_Facing;
  std::string         m_SourceSide;
  std::vector<double> m_Distances;
};

/** \struct ScanFrames
 * \brief The dental frames of what was loaded, and what the checks say of the scans; both have run. */
struct ScanFrames
{
  using AxisType = itk::UMidlineDentalAxisFilter<itk::DentalCaseData::MeshType>;

  AxisType::Pointer             axis;   /**< Finds the frame of each scan. */
  itk::ScanCheckFilter::Pointer checks; /**< Judges the scans before they are used. */
};

/** Finds the frames and checks the scans; warnings and findings go to stderr, in the words of `register`. Throws
 * DentalInputError where a scan has no arch. */
CommandLine_EXPORT ScanFrames
FindFrames(const itk::DentalCaseData & data, bool refineMidline = false);

/** Adds --view NAME. */
CommandLine_EXPORT void
AddViewOption(CLI::App * command, std::string & view);

/** What a case knows of a radiograph: of the view of that name, else ("" or "lateral") its own. Throws DentalInputError
 * that lists the views. */
CommandLine_EXPORT const itk::DentalRadiographData &
                         FindView(const itk::DentalCaseData & data, const std::string & name);

/** The geometry of a view with a jaw placed in it: the central ray through the jaw's centroid, or, where a result file
 * is named, as it was registered there, with the scale and the principal point in use then. Throws DentalInputError
 * where the result lacks the view or the jaw. */
CommandLine_EXPORT itk::CephalometricGeometry::Pointer
                   PlaceJaw(const itk::DentalCaseData &    data,
                            itk::ToothCode::JawEnum        jaw,
                            const itk::DentalFrameResult & frames,
                            const std::string &            resultFile,
                            const std::string &            view = {});
} // namespace dentalscr

#endif
