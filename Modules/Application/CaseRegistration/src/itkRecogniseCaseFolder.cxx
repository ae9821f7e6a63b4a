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
#include "itkRecogniseCaseFolder.h"

#include "itkASCIICharacter.h"
#include "itkCephalogramFileReader.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkForeignFile.h"
#include "itkJsonDocument.h"
#include "itkLowerCase.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::set<std::string> ScanExtensions{ ".stl", ".ply", ".obj", ".off", ".vtk", ".vtp" };
const std::set<std::string> PictureExtensions{ ".png",  ".jpg", ".jpeg", ".tif", ".tiff",  ".bmp",
                                               ".nrrd", ".mha", ".mhd",  ".dcm", ".dicom", ".ima" };
const std::set<std::string> DrawingExtensions{ ".json", ".csv", ".tsv", ".txt", ".xml", ".wceph" };

const std::set<std::string> UpperWords{ "upper",   "upperjaw",  "upperjawscan", "upperarch",
                                        "maxilla", "maxillary", "maxillar",     "oberkiefer" };
const std::set<std::string> LowerWords{ "lower",    "lowerjaw",   "lowerjawscan", "lowerarch",
                                        "mandible", "mandibular", "mandibula",    "unterkiefer" };
const std::set<std::string> BothWords{ "lockedocclusion", "bite", "bitescan", "buccal" };
/** A scan before the teeth were prepared: it has teeth that the other one has not. */
const std::set<std::string> EarlierWords{ "situ", "preop", "prep", "preparation", "preprep" };
const std::set<std::string> RadiographWords{ "ceph",          "cephalogram",    "cephalo",
                                             "cephalometric", "cephalometry",   "lateral",
                                             "radiograph",    "teleradiograph", "teleradiography",
                                             "xray" };
/** What was taken from the front, or drawn on such a radiograph. */
const std::set<std::string> FrontalWords{ "frontal", "pa", "ap", "posteroanterior", "anteroposterior", "coronal" };
/** Pictures that are made of a radiograph. */
const std::set<std::string> DerivedWords{ "overlay", "mask", "masks", "label", "labels", "seg", "segmentation", "drr" };

/** Words of a name: between what is neither letter nor digit, and where a small letter is followed by a capital one.
 * The whole of what stands between two signs is a word as well: "UpperJaw" is upper, jaw and upperjaw. */
Words
SplitWords(const std::string & name)
{
  Words       words;
  std::string part;
  std::string whole;
  const auto  add = [&words](std::string & word) {
    if (!word.empty())
    {
      words.push_back(LowerCase(word));
    }
    word.clear();
  };
  for (std::size_t i = 0; i <= name.size(); ++i)
  {
    const char c = i < name.size() ? name[i] : '.';
    if (!IsASCIIAlphanumeric(c))
    {
      const bool several = whole.size() > part.size();
      add(part);
      if (several)
      {
        add(whole);
      }
      whole.clear();
      continue;
    }
    if (!part.empty() && IsASCIILowerCase(part.back()) && IsASCIIUpperCase(c))
    {
      add(part);
    }
    part += c;
    whole += c;
  }
  return words;
}

bool
HasAny(const Words & words, const std::set<std::string> & known)
{
  return std::any_of(words.begin(), words.end(), [&](const std::string & word) { return known.count(word) != 0; });
}

/** iTero names its jaws by a letter behind two words. */
bool
EndsLikeITero(const Words & words, const char * letter)
{
  const std::size_t n = words.size();
  return n >= 3 && words[n - 3] == "shell" && words[n - 2] == "occlusion" && words[n - 1] == letter;
}

/** A NIfTI image, by the end of its name, of which the usual extension is a part alone. */
bool
IsNifti(const std::string & file)
{
  const std::string name = LowerCase(fs::path(file).filename().string());
  const auto        endsWith = [&name](const std::string & end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  return endsWith(".nii") || endsWith(".nii.gz");
}

/** What a reader makes of a file; nothing where it refuses it. \param problem  gets what it says then. */
template <typename TRead>
bool
Reads(const TRead & read, std::string * problem = nullptr)
{
  try
  {
    return read();
  }
  catch (const DentalInputError & error)
  {
    if (problem != nullptr)
    {
      *problem = (error.GetField().empty() ? "" : error.GetField() + ": ") + error.GetProblem();
    }
    return false;
  }
  catch (const ExceptionObject &)
  {
    return false;
  }
}

/** A file that is of no use for any field, named for what it is, with what to do; "" where it may be of use. */
std::string
DescribeForeign(const std::string & file)
{
  try
  {
    RefuseForeignFile(file, FilePurposeEnum::Tracing);
    RefuseForeignFile(file, FilePurposeEnum::Radiograph);
    RefuseForeignFile(file, FilePurposeEnum::Scan);
  }
  catch (const DentalInputError & error)
  {
    // The purpose that it does not serve is none of its own: "is a GIF picture, no tracing".
    const std::string problem = error.GetProblem();
    return "it " + problem.substr(0, problem.rfind(", no ")) + "; " + error.GetRemedy();
  }
  return std::string();
}

/** What a DICOM file says of where it was taken from; nothing where it is none, or does not tell. */
std::optional<CephalometricGeometry::DirectionEnum>
DirectionOfDicom(const std::string & file)
{
  const std::string extension = LowerCase(fs::path(file).extension().string());
  if (extension != ".dcm" && extension != ".dicom" && extension != ".ima")
  {
    return std::nullopt;
  }
  std::optional<CephalometricGeometry::DirectionEnum> direction;
  Reads([&]() {
    auto reader = CephalogramFileReader::New();
    reader->SetFileName(file);
    reader->UpdateOutputInformation();
    if (reader->HasRadiographDirection())
    {
      direction = reader->GetRadiographDirection();
    }
    return true;
  });
  return direction;
}

/** The one tooth that a tracing is of; "" where it is of several or of a jaw. */
std::string
FindOnlyTooth(const DentalContourFileReader & reader)
{
  std::set<std::string> teeth;
  for (const auto jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
  {
    for (const auto & polyline : reader.GetOutput(jaw)->GetPolylines())
    {
      if (!polyline.points.empty())
      {
        teeth.insert(polyline.code.IsKnown() ? polyline.code.GetName() : std::string());
      }
    }
  }
  return teeth.size() == 1 ? *teeth.begin() : std::string();
}

/** The tooth or jaw that a word of a name is; "" where none is, or several are. */
std::string
FindToothOfName(const std::string & file)
{
  std::set<std::string> found;
  const Words           words = SplitWords(fs::path(file).stem().string());
  if (HasAny(words, UpperWords))
  {
    found.insert("upper");
  }
  if (HasAny(words, LowerWords))
  {
    found.insert("lower");
  }
  for (const std::string & word : words)
  {
    try
    {
      if (ToothCode::IsWrittenAsCode(word) && ToothCode::FromString(word).IsKnown())
      {
        found.insert(ToothCode::FromString(word).GetName());
      }
    }
    catch (const std::invalid_argument &)
    {
      // A number of something else.
      continue;
    }
  }
  return found.size() == 1 ? *found.begin() : std::string();
}

/** Candidates for one field. */
struct Candidates
{
  std::vector<std::string> files;
  std::vector<std::string> reasons;
};

std::string
NameOf(const std::string & file)
{
  return fs::path(file).filename().string();
}

/** A JSON file of this toolkit that is none of the things to draw with. */
std::string
DescribeOwnJson(const std::string & file)
{
  std::string kind;
  Reads([&]() {
    const auto root = JsonDocument::ReadFile(file).GetRoot();
    kind = root.IsObject() && root.Find("schema") ? "a result or a record of this toolkit"
           : IsDentalCaseFile(file)               ? "a case file"
                                                  : "";
    return true;
  });
  return kind;
}

class Recogniser
{
public:
  explicit Recogniser(const std::string & folder)
  {
    std::error_code error;
    if (!fs::is_directory(folder, error))
    {
      itkDentalInputErrorMacro(folder, "", "is no folder", "name the folder with the patient's files");
    }
    for (const auto & entry : fs::directory_iterator(folder))
    {
      if (entry.is_regular_file(error) && entry.path().filename().string()[0] != '.')
      {
        m_Files.push_back(entry.path().string());
      }
    }
    std::sort(m_Files.begin(), m_Files.end());
  }

  RecognisedCase
  Run()
  {
    Words drawings;
    for (const std::string & file : m_Files)
    {
      const std::string extension = LowerCase(fs::path(file).extension().string());
      if (ScanExtensions.count(extension) != 0)
      {
        this->LookAtScan(file);
      }
      else if (PictureExtensions.count(extension) != 0 || IsNifti(file))
      {
        this->LookAtPicture(file);
      }
      else if (DrawingExtensions.count(extension) != 0)
      {
        drawings.push_back(file);
      }
      else
      {
        const std::string foreign = DescribeForeign(file);
        this->Note(file, "not used: " + (foreign.empty() ? "it is of no kind that is read" : foreign));
      }
    }
    this->Settle("upper");
    this->Settle("lower");
    this->SettlePicture();
    for (const std::string & file : drawings)
    {
      this->LookAtDrawing(file);
    }
    for (const std::string & file : m_Derived)
    {
      this->LookAtDerivedPicture(file);
    }
    for (const char * field : { "contours",
                                "cephalometric_landmarks",
                                "landmarks_3d",
                                "landmarks_2d",
                                "views.frontal.contours",
                                "views.frontal.cephalometric_landmarks" })
    {
      this->Settle(field);
    }
    this->SettleFrontal();
    this->SayWhatIsMissing();
    return m_Case;
  }

private:
  void
  Note(const std::string & file, const std::string & text)
  {
    m_Case.notes.push_back(NameOf(file) + ": " + text);
  }

  void
  Add(const std::string & field, const std::string & file, const std::string & reason)
  {
    m_Candidates[field].files.push_back(file);
    m_Candidates[field].reasons.push_back(reason);
  }

  void
  LookAtScan(const std::string & file)
  {
    const Words words = SplitWords(fs::path(file).stem().string());
    const bool  upper = HasAny(words, UpperWords) || EndsLikeITero(words, "u");
    const bool  lower = HasAny(words, LowerWords) || EndsLikeITero(words, "l");
    if (HasAny(words, BothWords))
    {
      this->Note(file, "not used: by its name it holds both jaws, or how they bite");
    }
    else if (upper == lower)
    {
      this->Note(file,
                 upper ? "not used: its name has words of both jaws"
                       : "not used: no word of its name tells the jaw; write it as \"upper\" or \"lower\" of the case");
    }
    else if (HasAny(words, EarlierWords))
    {
      m_Earlier[upper ? "upper" : "lower"].push_back(file);
    }
    else
    {
      this->Add(
        upper ? "upper" : "lower", file, upper ? "upper, by a word of its name" : "lower, by a word of its name");
    }
  }

  void
  LookAtPicture(const std::string & file)
  {
    try
    {
      RefuseForeignFile(file, FilePurposeEnum::Radiograph);
    }
    catch (const DentalInputError &)
    {
      this->Note(file, "not used: " + DescribeForeign(file));
      return;
    }
    const Words words = SplitWords(fs::path(file).stem().string());
    // Programs of segmentation write NIfTI, and call it as the radiograph is called.
    if (HasAny(words, DerivedWords) || (IsNifti(file) && this->HoldsTeeth(file)))
    {
      m_Derived.push_back(file);
      return;
    }
    if (const auto direction = DirectionOfDicom(file))
    {
      const bool isFrontal = *direction == CephalometricGeometry::DirectionEnum::Frontal;
      m_ByDicom.insert(file);
      (isFrontal ? m_FrontalRadiographs : m_Radiographs).push_back(file);
      return;
    }
    (HasAny(words, FrontalWords)      ? m_FrontalRadiographs
     : HasAny(words, RadiographWords) ? m_Radiographs
                                      : m_OtherPictures)
      .push_back(file);
  }

  void
  SettlePicture()
  {
    // Of one radiograph alone the words may be a patient's initials.
    if (m_Radiographs.empty() && m_OtherPictures.empty() && m_FrontalRadiographs.size() == 1 &&
        m_ByDicom.count(m_FrontalRadiographs.front()) == 0)
    {
      m_Radiographs.swap(m_FrontalRadiographs);
    }
    for (const std::string & file : m_FrontalRadiographs)
    {
      this->Add("views.frontal.cephalogram.image",
                file,
                m_ByDicom.count(file) != 0 ? "a frontal radiograph, by its DICOM tags"
                                           : "a frontal radiograph, by a word of its name");
    }
    this->Settle("views.frontal.cephalogram.image");
    const bool                       named = !m_Radiographs.empty();
    const std::vector<std::string> & files = named ? m_Radiographs : m_OtherPictures;
    for (const std::string & file : files)
    {
      this->Add("cephalogram.image",
                file,
                m_ByDicom.count(file) != 0 ? "the radiograph, by its DICOM tags"
                : named                    ? "the radiograph, by a word of its name"
                                           : "the radiograph, as there is no other picture");
    }
    if (named)
    {
      for (const std::string & file : m_OtherPictures)
      {
        this->Note(file, "not used: another picture is named as the radiograph");
      }
    }
    this->Settle("cephalogram.image");
    const std::string image = m_Case.Find("cephalogram.image");
    if (image.empty())
    {
      return;
    }
    std::tie(m_ImageSize, m_HasSpacing) = this->MeasurePicture(image);
    const std::string frontal = m_Case.Find("views.frontal.cephalogram.image");
    if (!frontal.empty())
    {
      m_FrontalSize = this->MeasurePicture(frontal).first;
    }
  }

  /** Its size, and whether it tells a pixel's length. */
  std::pair<Size<2>, bool>
  MeasurePicture(const std::string & image)
  {
    auto reader = CephalogramFileReader::New();
    reader->SetFileName(image);
    try
    {
      reader->UpdateOutputInformation();
      return { reader->GetOutput()->GetLargestPossibleRegion().GetSize(), reader->HasPixelSpacing() };
    }
    catch (const ExceptionObject & error)
    {
      this->Note(image, std::string("cannot be read: ") + error.GetDescription());
      return { Size<2>{ { 0, 0 } }, false };
    }
  }

  void
  LookAtDrawing(const std::string & file)
  {
    const std::string own = DescribeOwnJson(file);
    if (!own.empty())
    {
      this->Note(file, "not used: it is " + own);
      return;
    }
    const std::string frontalImage = m_Case.Find("views.frontal.cephalogram.image");
    const bool        isFrontal =
      HasAny(SplitWords(fs::path(file).stem().string()), FrontalWords) && !m_FrontalRadiographs.empty();
    const std::string view = isFrontal ? "views.frontal." : "";
    bool              sided = false;
    std::string       problem;
    if (Reads(
          [&]() {
            auto reader = DentalContourFileReader::New();
            reader->SetFileName(file);
            reader->SetImageSize(isFrontal ? m_FrontalSize : m_ImageSize);
            reader->SetImageFileName(isFrontal ? frontalImage : m_Case.Find("cephalogram.image"));
            // Whatever a millimetre is: this is about what the file holds.
            AnnotationFileReaderBase::VectorType spacing;
            spacing.Fill(1.0);
            reader->SetMarkupsSpacing(spacing);
            reader->Update();
            m_HasMarkups = m_HasMarkups || reader->GetReadFileFormat() == AnnotationFileFormatEnum::SlicerMarkups;
            m_ToothOf[file] = FindOnlyTooth(*reader);
            m_HasRuler = m_HasRuler || (!isFrontal && !reader->GetCalibrations().empty());
            return reader->GetUpperOutput()->GetNumberOfPoints() + reader->GetLowerOutput()->GetNumberOfPoints() > 0;
          },
          &problem))
    {
      this->Add(view + "contours",
                file,
                isFrontal ? "a tracing of the frontal radiograph, by a word of its name"
                          : "a tracing: it holds curves with tooth codes");
    }
    else if (Reads([&]() {
               auto reader = DentalLandmarkFileReader<3>::New();
               reader->SetFileName(file);
               reader->Update();
               return reader->GetOutput()->GetNumberOfLandmarks() > 0;
             }))
    {
      this->Add("landmarks_3d", file, "landmarks of the scans: points with three coordinates");
    }
    else if (Reads([&]() {
               auto reader = CephalometricLandmarkFileReader::New();
               reader->SetFileName(file);
               reader->SetImageFileName(m_Case.Find("cephalogram.image"));
               reader->Update();
               m_HasMarkups = m_HasMarkups || reader->GetReadFileFormat() == AnnotationFileFormatEnum::SlicerMarkups;
               const auto & landmarks = reader->GetOutput()->GetLandmarks();
               sided = std::all_of(landmarks.begin(), landmarks.end(), [](const auto & landmark) {
                 return landmark.meaning.tooth.IsKnown();
               });
               return !landmarks.empty();
             }))
    {
      if (isFrontal)
      {
        this->Add(view + "cephalometric_landmarks",
                  file,
                  "landmarks of the frontal radiograph, by a word of its name, to register with");
      }
      else if (sided)
      {
        this->Add(
          "landmarks_2d",
          file,
          "landmarks of the radiograph whose names tell their sides: they measure errors and are not registered "
          "with; to register with them call the field cephalometric_landmarks");
      }
      else
      {
        this->Add("cephalometric_landmarks", file, "landmarks of a cephalometric analysis, to register with");
      }
    }
    else
    {
      const std::string foreign = DescribeForeign(file);
      this->Note(file,
                 "not used: " + (!foreign.empty()
                                   ? foreign
                                   : "neither a tracing nor landmarks can be read from it" +
                                       (problem.empty() ? problem : "; as a tracing it has this fault: " + problem)));
    }
  }

  /** Whether a picture is a label map, whose numbers are teeth, in the grid of the radiograph where that is known. */
  bool
  HoldsTeeth(const std::string & file, std::string * problem = nullptr) const
  {
    const auto read = [&]() {
      auto reader = DentalContourFileReader::New();
      reader->SetFileName(file);
      reader->SetImageSize(m_ImageSize);
      reader->Update();
      return reader->GetUpperOutput()->GetNumberOfPoints() + reader->GetLowerOutput()->GetNumberOfPoints() > 0;
    };
    return Reads(read, problem);
  }

  /** Whether a picture shows something of two tones in the grid of the radiograph. */
  bool
  IsMask(const std::string & file, const std::string & tooth) const
  {
    return Reads([&]() {
      auto reader = DentalContourFileReader::New();
      reader->SetClassFiles({ { tooth, file } });
      reader->SetImageSize(m_ImageSize);
      reader->Update();
      return reader->GetUpperOutput()->GetNumberOfPoints() + reader->GetLowerOutput()->GetNumberOfPoints() > 0;
    });
  }

  /** Where every candidate is of one tooth or jaw, each of another: together they are the tracing. */
  bool
  SettleParts(const std::string & field)
  {
    const Candidates &    candidates = m_Candidates[field];
    std::set<std::string> teeth;
    for (const std::string & file : candidates.files)
    {
      teeth.insert(m_ToothOf[file]);
    }
    if (candidates.files.size() < 2 || teeth.size() != candidates.files.size() || teeth.count(std::string()) != 0)
    {
      return false;
    }
    for (std::size_t i = 0; i < candidates.files.size(); ++i)
    {
      const std::string & file = candidates.files[i];
      m_Case.files.emplace_back(field + "." + m_ToothOf[file], file);
      this->Note(file, candidates.reasons[i] + "; of " + m_ToothOf[file] + " alone, as the other files are of others");
    }
    return true;
  }

  void
  LookAtDerivedPicture(const std::string & file)
  {
    std::string problem;
    if (this->HoldsTeeth(file, &problem))
    {
      this->Add("contours", file, "a tracing: a label map with teeth");
      return;
    }
    const std::string tooth = FindToothOfName(file);
    if (!tooth.empty() && this->IsMask(file, tooth))
    {
      m_ToothOf[file] = tooth;
      m_Masks.insert(file);
      this->Add("contours", file, "a mask or drawn lines, of which a word of its name tells the tooth or jaw");
      return;
    }
    this->Note(file,
               "not used: by its name it was made of a radiograph and is none" +
                 (problem.empty() ? problem : "; as a label map it has this fault: " + problem));
  }

  /** One candidate is taken, of several none. */
  void
  Settle(const std::string & field)
  {
    Candidates & candidates = m_Candidates[field];
    if (candidates.files.empty() && m_Earlier[field].size() == 1)
    {
      this->Add(
        field, m_Earlier[field].front(), field + ", by a word of its name, before preparation, as there is no other");
      m_Earlier[field].clear();
    }
    for (const std::string & file : m_Earlier[field])
    {
      this->Note(file, "not used: by its name it was scanned before the teeth were prepared");
    }
    m_Earlier[field].clear();
    if (candidates.files.size() == 1)
    {
      const std::string & file = candidates.files.front();
      // A mask says nothing of what it shows, and so its tooth has to stand beside it.
      m_Case.files.emplace_back(m_Masks.count(file) != 0 ? field + "." + m_ToothOf[file] : field, file);
      this->Note(candidates.files.front(), candidates.reasons.front());
      return;
    }
    if (field == "contours" && this->SettleParts(field))
    {
      return;
    }
    for (const std::string & file : candidates.files)
    {
      this->Note(file,
                 "not used: one of " + std::to_string(candidates.files.size()) + " that could be \"" + field +
                   "\"; write the right one into the case");
    }
  }

  /** A view on which nothing was drawn is none. */
  void
  SettleFrontal()
  {
    const std::string prefix = "views.frontal.";
    const std::string image = m_Case.Find(prefix + "cephalogram.image");
    const bool        isDrawn =
      !m_Case.Find(prefix + "contours").empty() || !m_Case.Find(prefix + "cephalometric_landmarks").empty();
    if (image.empty() || !isDrawn)
    {
      for (const auto & file : m_Case.files)
      {
        if (file.first.compare(0, prefix.size(), prefix) == 0)
        {
          this->Note(file.second,
                     image.empty() ? "not used after all: which picture it was drawn on is not known"
                                   : "not used after all: no tracing and no landmarks have a word as \"frontal\" or "
                                     "\"pa\" in their names, as what was drawn on it should");
        }
      }
      m_Case.files.erase(
        std::remove_if(m_Case.files.begin(),
                       m_Case.files.end(),
                       [&prefix](const auto & file) { return file.first.compare(0, prefix.size(), prefix) == 0; }),
        m_Case.files.end());
      return;
    }
    m_Case.notes.emplace_back("taken for granted: the head stood still between the radiographs, and the frontal one "
                              "shows the patient's left at its right; else give \"same_head_position\": false and "
                              "\"patient_left\" of the view; worth giving: its \"principal_point_px\"");
  }

  void
  SayWhatIsMissing()
  {
    const auto has = [this](const std::string & field) {
      return std::any_of(m_Case.files.begin(), m_Case.files.end(), [&field](const auto & file) {
        return file.first == field || file.first.compare(0, field.size() + 1, field + ".") == 0;
      });
    };
    if (!has("upper") && !has("lower"))
    {
      m_Case.notes.emplace_back("still to be given: \"upper\" or \"lower\", the scans");
    }
    if (!has("contours") && !has("cephalometric_landmarks"))
    {
      m_Case.notes.emplace_back(
        "still to be given: \"contours\" or \"cephalometric_landmarks\", what was drawn on the radiograph");
    }
    if (m_HasMarkups && !m_HasSpacing)
    {
      m_Case.notes.emplace_back(
        "still to be given: \"markups_spacing_mm\", as markups are in mm: the spacing [u, v] that "
        "the radiograph had in 3D Slicer, [1, 1] where its Volumes module shows none");
    }
    if (!m_HasSpacing && !m_HasRuler)
    {
      m_Case.notes.emplace_back("worth giving: \"pixel_spacing_mm\" of \"cephalogram\", which no file tells; without "
                                "it the scale is estimated");
    }
    m_Case.notes.emplace_back(
      "taken for granted: the patient faces right and the right side was traced; else give \"facing\" "
      "and \"traced_side\"");
  }

  std::vector<std::string> m_Files;
  std::vector<std::string> m_Radiographs;
  std::vector<std::string> m_FrontalRadiographs;
  std::vector<std::string> m_OtherPictures;
  std::vector<std::string> m_Derived;
  /** The one tooth or jaw that a candidate is of. */
  std::map<std::string, std::string> m_ToothOf;
  std::set<std::string>              m_Masks;
  bool                               m_HasMarkups{ false };
  /** A line of known length in a tracing is the pixel spacing. */
  bool m_HasRuler{ false };
  /** Pictures whose tags tell from where they were taken. */
  std::set<std::string>                           m_ByDicom;
  std::map<std::string, Candidates>               m_Candidates;
  std::map<std::string, std::vector<std::string>> m_Earlier;
  Size<2>                                         m_ImageSize{ { 0, 0 } };
  Size<2>                                         m_FrontalSize{ { 0, 0 } };
  bool                                            m_HasSpacing{ false };
  RecognisedCase                                  m_Case;
};
} // namespace

std::string
RecognisedCase::Find(const std::string & field) const
{
  for (const auto & file : files)
  {
    if (file.first == field)
    {
      return file.second;
    }
  }
  return "";
}

RecognisedCase
RecogniseCaseFolder(const std::string & folder)
{
  return Recogniser(folder).Run();
}
} // namespace itk
