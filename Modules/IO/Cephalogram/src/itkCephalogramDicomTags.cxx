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
#include "itkCephalogramFileReader.h"

#include "itkRadiographFile.h"
#include "itkRadiographText.h"

#include "itkMetaDataObject.h"

// What a DICOM file says of distances, spacing and facing, and which of it can be believed: apart from the reader,
// which is about pixels.
namespace itk
{
namespace
{
using namespace RadiographText;
} // namespace

std::string
CephalogramFileReader::GetTag(const char * key) const
{
  std::string value;
  ExposeMetaData<std::string>(m_File->GetImageIO()->GetMetaDataDictionary(), key, value);
  return Trim(value);
}

std::optional<double>
CephalogramFileReader::ReadPositiveTag(const char * key, const char * name)
{
  const std::string text = this->GetTag(key);
  if (text.empty())
  {
    return std::nullopt;
  }
  double value = 0.0;
  if (!ParseNumber(text, value) || value <= 0.0)
  {
    this->Warn(name, "\"" + text.substr(0, 40) + "\" is no number above 0, ignored");
    return std::nullopt;
  }
  return value;
}

std::optional<std::array<double, 2>>
CephalogramFileReader::ReadSpacingTag(const char * key, const char * name)
{
  const std::string text = this->GetTag(key);
  if (text.empty())
  {
    return std::nullopt;
  }
  const std::size_t     separator = text.find('\\');
  std::array<double, 2> spacing{ { 0.0, 0.0 } };
  if (separator == std::string::npos || !ParseNumber(text.substr(0, separator), spacing[0]) ||
      !ParseNumber(text.substr(separator + 1), spacing[1]) || spacing[0] <= 0.0 || spacing[1] <= 0.0)
  {
    this->Warn(name, "\"" + text.substr(0, 40) + "\" is no pair of numbers above 0, ignored");
    return std::nullopt;
  }
  return spacing;
}

void
CephalogramFileReader::ReadDicomTags()
{
  RadiographSpacingTags tags;
  tags.imagerPixelSpacing = this->ReadSpacingTag("0018|1164", "ImagerPixelSpacing (0018,1164)");
  tags.pixelSpacing = this->ReadSpacingTag("0028|0030", "PixelSpacing (0028,0030)");
  tags.calibrationType = this->GetTag("0028|0a02");
  tags.calibrationDescription = this->GetTag("0028|0a04").substr(0, 200);

  constexpr const char * factorName = "EstimatedRadiographicMagnificationFactor (0018,1114)";
  m_MagnificationFactor = this->ReadPositiveTag("0018|1114", factorName);
  if (m_MagnificationFactor && *m_MagnificationFactor <= 1.0)
  {
    // The patient is between source and detector; 1 stands for "not entered".
    this->Warn(factorName, ToString(*m_MagnificationFactor) + " is not above 1, ignored");
    m_MagnificationFactor.reset();
  }
  else if (m_MagnificationFactor && *m_MagnificationFactor > 100.0 && *m_MagnificationFactor <= 150.0)
  {
    this->Warn(factorName, ToString(*m_MagnificationFactor) + " is taken to be per cent");
    *m_MagnificationFactor /= 100.0;
  }
  else if (m_MagnificationFactor && *m_MagnificationFactor > 2.0)
  {
    this->Warn(factorName, ToString(*m_MagnificationFactor) + " is no cephalostat's (1.05 to 1.15), ignored");
    m_MagnificationFactor.reset();
  }
  else if (m_MagnificationFactor && *m_MagnificationFactor > 1.35)
  {
    this->Warn(factorName, ToString(*m_MagnificationFactor) + " is unusual for a cephalostat (1.05 to 1.15)");
  }
  tags.magnificationFactor = m_MagnificationFactor;

  const PixelSpacingDecision decision = DecidePixelSpacing(tags);
  m_PixelSpacingVerdict = decision.verdict;
  m_SpacingPlane = decision.plane;
  if (decision.spacing)
  {
    m_PixelSpacing = PixelSpacingType(decision.spacing->data());
    PixelSpacingType imager;
    // The file has that between rows first.
    imager[0] = (*tags.imagerPixelSpacing)[1];
    imager[1] = (*tags.imagerPixelSpacing)[0];
    m_ImagerPixelSpacing = imager;
    for (const double value : *decision.spacing)
    {
      if (value < 0.01 || value > 1.0)
      {
        this->Warn("pixel_spacing", ToString(value) + " mm is unusual for a cephalogram (0.05 to 0.3)");
        break;
      }
    }
  }
  m_Provenance["pixel_spacing"] = decision.reason;
  if (decision.verdict == PixelSpacingVerdictEnum::Unknown)
  {
    const std::string scanned = this->GetTag("0018|2010");
    if (!scanned.empty())
    {
      m_Provenance["pixel_spacing"] +=
        "; NominalScannedPixelSpacing (0018,2010) " + scanned.substr(0, 40) + " is the film scanner's, not used";
    }
  }

  constexpr const char * detectorName = "DistanceSourceToDetector (0018,1110)";
  m_SourceToDetectorDistance = this->ReadPositiveTag("0018|1110", detectorName);
  if (m_SourceToDetectorDistance)
  {
    m_Provenance["source_to_detector"] = std::string(detectorName) + ' ' + ToString(*m_SourceToDetectorDistance);
    if (*m_SourceToDetectorDistance < 1000.0 || *m_SourceToDetectorDistance > 5000.0)
    {
      this->Warn(detectorName,
                 ToString(*m_SourceToDetectorDistance) + " mm is unusual for a cephalostat (1500 to 2000, up to 4000)");
    }
    if (m_MagnificationFactor)
    {
      m_SourceToMidsagittalDistance = *m_SourceToDetectorDistance / *m_MagnificationFactor;
      m_Provenance["source_to_midsagittal"] =
        m_Provenance["source_to_detector"] + " / " + factorName + ' ' + ToString(*m_MagnificationFactor);
    }
  }
  const std::string patient = this->GetTag("0018|1111");
  if (!patient.empty())
  {
    m_Provenance["distance_source_to_patient"] =
      "DistanceSourceToPatient (0018,1111) " + patient.substr(0, 40) + ", not the midsagittal plane's, not used";
  }

  // Postero-anterior and antero-posterior are frontal; the others name the side that lies on the detector.
  const std::string position = this->GetTag("0018|5101");
  if (position == "PA" || position == "AP")
  {
    m_RadiographDirection = DirectionEnum::Frontal;
    m_FrontalSource = position == "PA" ? FrontalSourceEnum::Behind : FrontalSourceEnum::InFront;
    m_Provenance["direction"] = "ViewPosition (0018,5101) " + position;
  }
  else if (position == "LL" || position == "RL" || position == "LLD" || position == "RLD")
  {
    m_RadiographDirection = DirectionEnum::Lateral;
    m_Provenance["direction"] = "ViewPosition (0018,5101) " + position;
  }

  // Direction of the rows (to the right), then of the columns (down): a lateral cephalogram has A\F or P\F, a frontal
  // one L\F or R\F.
  const std::string orientation = this->GetTag("0020|0020");
  if (!orientation.empty())
  {
    const std::size_t separator = orientation.find('\\');
    const std::string rows = Trim(orientation.substr(0, separator));
    const std::string columns =
      separator == std::string::npos ? std::string() : Trim(orientation.substr(separator + 1));
    if (!rows.empty() && (rows[0] == 'A' || rows[0] == 'P') && !columns.empty() && columns[0] == 'F')
    {
      m_Facing = rows[0] == 'A' ? FacingEnum::Right : FacingEnum::Left;
      m_Provenance["facing"] = "PatientOrientation (0020,0020) " + orientation.substr(0, 40);
    }
    else if (!rows.empty() && (rows[0] == 'L' || rows[0] == 'R') && !columns.empty() && columns[0] == 'F')
    {
      m_PatientLeft = rows[0] == 'L' ? PatientLeftEnum::Right : PatientLeftEnum::Left;
      m_Provenance["patient_left"] = "PatientOrientation (0020,0020) " + orientation.substr(0, 40);
    }
    else
    {
      this->Warn("PatientOrientation (0020,0020)",
                 "\"" + orientation.substr(0, 40) +
                   "\" is not that of an upright lateral or frontal view (A\\F, P\\F, L\\F or R\\F), ignored");
    }
    if (!m_RadiographDirection && (m_Facing || m_PatientLeft))
    {
      m_RadiographDirection = m_Facing ? DirectionEnum::Lateral : DirectionEnum::Frontal;
      m_Provenance["direction"] = "PatientOrientation (0020,0020) " + orientation.substr(0, 40);
    }
  }

  const std::string photometric = this->GetTag("0028|0004");
  if (!photometric.empty())
  {
    m_Provenance["photometric"] = "PhotometricInterpretation (0028,0004) " + photometric.substr(0, 40) +
                                  (photometric == "MONOCHROME1" ? ", inverted on reading" : "");
  }
  const std::string modality = this->GetTag("0008|0060");
  if (modality == "CT" || modality == "MR" || modality == "PT" || modality == "US" || modality == "NM")
  {
    this->Warn("Modality (0008,0060)", "\"" + modality + "\" is no projection radiograph");
  }
}
} // namespace itk
