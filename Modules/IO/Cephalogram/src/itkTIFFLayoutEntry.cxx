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
#include "itkTIFFLayoutEntry.h"

#include "itkMetaDataObject.h"

#include <locale>
#include <sstream>
#include <string>

namespace itk
{
namespace
{
constexpr char EntryName[] = "DentalSCRTIFFLayout";
} // namespace

void
PutTIFFLayout(const TIFFLayout & layout, MetaDataDictionary & dictionary)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << layout.width << ' ' << layout.height << ' ' << layout.pages << ' ' << layout.bits << ' ' << layout.samples
     << ' ' << layout.isInterleaved << ' ' << layout.isInteger << ' ' << layout.isSigned << ' ' << layout.isPalette
     << ' ' << layout.isWhiteIsZero << ' ' << layout.isGrey << ' ' << layout.orientation;
  EncapsulateMetaData<std::string>(dictionary, EntryName, os.str());
}

std::optional<TIFFLayout>
FindTIFFLayout(const MetaDataDictionary & dictionary)
{
  std::string text;
  if (!ExposeMetaData<std::string>(dictionary, EntryName, text))
  {
    return std::nullopt;
  }
  std::istringstream is(text);
  is.imbue(std::locale::classic());
  TIFFLayout layout;
  is >> layout.width >> layout.height >> layout.pages >> layout.bits >> layout.samples >> layout.isInterleaved >>
    layout.isInteger >> layout.isSigned >> layout.isPalette >> layout.isWhiteIsZero >> layout.isGrey >>
    layout.orientation;
  if (!is || layout.orientation < 1 || layout.orientation > 8)
  {
    return std::nullopt;
  }
  return layout;
}
} // namespace itk
