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
#ifndef itkTIFFLayoutEntry_h
#define itkTIFFLayoutEntry_h

#include "itkTIFFLayout.h"

#include "itkMetaDataDictionary.h"

#include <optional>

namespace itk
{
/** Puts what a TIFF says of its pixels among the entries that the decoder sends. */
void
PutTIFFLayout(const TIFFLayout & layout, MetaDataDictionary & dictionary);

/** What the decoder has put there; none where libtiff could not open the file, or where it is no layout: it comes from
 * a process that decodes what others have made. */
std::optional<TIFFLayout>
FindTIFFLayout(const MetaDataDictionary & dictionary);
} // namespace itk

#endif
