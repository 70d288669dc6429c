#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::mesh {

/// A start tag of an XML file and the text up to the next tag.
struct XmlTag {
    std::string name;
    std::string parent;  ///< name of the element around it; empty for the root
    std::map<std::string, std::string> attributes;
    std::string_view text;
    int line = 0;
};

/// All start tags, in order, up to and with one called `last` (whose text is then the rest of the file: VTK's binary data follows there).
/// No entities, no CDATA. Throws InputError with file and line for tags that do not close or do not fit.
std::vector<XmlTag> xml_tags(std::string_view bytes, const std::string& file, std::string_view last);

}  // namespace cleave::mesh
