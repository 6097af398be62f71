// Reads values.npy of a .npz as cnpy does: local headers one after the other, sizes of 32 bits, arrays inflated by zlib.
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

int main(int, char** argv) {
    std::ifstream file(argv[1], std::ios::binary);
    const std::string data((std::istreambuf_iterator<char>(file)), {});
    for (size_t at = 0; data.compare(at, 4, "PK\x03\x04") == 0;) {
        uint16_t method, name, extra;
        uint32_t packed, size;
        std::memcpy(&method, &data[at + 8], 2), std::memcpy(&packed, &data[at + 18], 4);
        std::memcpy(&size, &data[at + 22], 4), std::memcpy(&name, &data[at + 26], 2);
        std::memcpy(&extra, &data[at + 28], 2);
        const size_t start = at + 30 + name + extra;
        if (method != 8 || start + packed > data.size()) return 1;
        std::vector<unsigned char> out(size);
        z_stream stream{};
        stream.next_in = (Bytef*)&data[start], stream.avail_in = packed;
        stream.next_out = out.data(), stream.avail_out = size;
        if (inflateInit2(&stream, -MAX_WBITS) != Z_OK || inflate(&stream, Z_FINISH) != Z_STREAM_END) return 2;
        inflateEnd(&stream);
        uint16_t length;
        std::memcpy(&length, &out[8], 2);
        const std::string header((char*)&out[10], length);
        const std::string said = data.substr(at + 30, name);
        if (said == "values.npy") {
            if (header.find("'descr': '<f4'") == std::string::npos) return 3;
            std::printf("%s\n", header.substr(header.find('('), header.find(')') - header.find('(') + 1).c_str());
            for (size_t k = 10 + length; k < size; k += 4) {
                float value;
                std::memcpy(&value, &out[k], 4), std::printf("%a\n", value);
            }
        } else if (header.find("'|u1'") == std::string::npos) return 4;
        at = start + packed;
    }
}
