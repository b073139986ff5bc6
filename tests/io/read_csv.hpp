// Reads comma-separated values as RFC 4180 has them, for tests of what writes them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tests {

/// The cells of each line, the header's first.
inline std::vector<std::vector<std::string>> read_csv(const std::string& text) {
    std::vector<std::vector<std::string>> lines;
    std::string cell;
    std::vector<std::string> line;
    bool quoted = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (quoted) {
            if (c == '"' && k + 1 < text.size() && text[k + 1] == '"')
                cell += text[++k];
            else if (c == '"')
                quoted = false;
            else
                cell += c;
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',' || c == '\n') {
            line.push_back(cell);
            cell.clear();
            if (c == '\n') {
                lines.push_back(line);
                line.clear();
            }
        } else {
            cell += c;
        }
    }
    return lines;
}

}  // namespace tests
