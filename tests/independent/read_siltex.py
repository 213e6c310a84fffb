#!/usr/bin/env python3
"""Reads a .siltex file as docs/formats/siltex.md describes it, without any code of the workspace, and prints what it holds.

    python3 tests/independent/read_siltex.py FILE.siltex
"""

import struct
import sys
import zlib

KNOWN = ["SIZE", "POSI", "TRIA", "CENT", "TANG", "PLAC", "ANGL", "TCEN", "GAPS", "COLO", "NORM", "META"]


def check(is_right, problem):
    if not is_right:
        raise SystemExit(f"refused: {problem}")


def table(data):
    check(data[:8] == b"\x89SILTEX\n", "no signature")
    check(len(data) >= 32, "cut short in the header")
    major, _minor, count, length, zero, checksum = struct.unpack_from("<HHIQII", data, 8)
    check(major == 1, f"major version {major}")
    check(length == len(data), f"{len(data)} bytes instead of {length}")
    check(count <= 256 and 32 + 32 * count <= length, "too many sections")
    check(zlib.crc32(data[:28] + data[32 : 32 + 32 * count]) == checksum, "checksum of the header")
    check(zero == 0, "reserved bits")
    sections, begin = {}, 32 + 32 * count
    for index in range(count):
        kind, flags, offset, size, checksum, zero = struct.unpack_from("<4sIQQII", data, 32 + 32 * index)
        kind = kind.decode("latin-1")
        end = (offset + size + 7) // 8 * 8
        check(flags <= 1 and zero == 0, f"reserved bits of {kind}")
        check(offset == begin and end <= length, f"place of {kind}")
        check(kind not in sections, f"two sections {kind}")
        check(kind in KNOWN or flags == 0, f"required section {kind}")
        if kind in KNOWN:
            check(zlib.crc32(data[offset:end]) == checksum, f"checksum of {kind}")
        sections[kind] = data[offset : offset + size]
        begin = end
    check(begin == length, "bytes after the last section")
    return {kind: content for kind, content in sections.items() if kind in KNOWN}


def numbers(sections, kind, form, count):
    content = sections[kind]
    check(len(content) == struct.calcsize(f"<{count}{form}"), f"length of {kind}")
    return struct.unpack(f"<{count}{form}", content)


def metadata(content):
    entries, at = [], 0
    while at < len(content):
        texts = []
        for _ in range(2):
            check(at + 4 <= len(content), "length of a text")
            (size,) = struct.unpack_from("<I", content, at)
            at += 4 + size
            check(at <= len(content), "text beyond its section")
            texts.append(content[at - size : at].decode("utf-8"))
        entries.append(tuple(texts))
    keys = [key.encode("utf-8") for key, _ in entries]
    check(all(keys) and keys == sorted(set(keys)), "keys")
    return entries


def mean(values):
    return sum(values) / len(values) if values else 0.0


def main():
    with open(sys.argv[1], "rb") as file:
        sections = table(file.read())
    for kind in KNOWN:
        check(kind in sections or kind in ("TCEN", "META"), f"no section {kind}")
    width, height, azimuths, pages, detail, vertices, faces, rule, form, terms = numbers(sections, "SIZE", "I", 10)
    check(rule <= 1 and form <= 2, "rule or form")
    texels = width * height * pages
    samples, details = texels * azimuths, texels * detail * detail
    positions = numbers(sections, "POSI", "f", 3 * vertices)
    triangles = numbers(sections, "TRIA", "I", 3 * faces)
    check(all(index < vertices for index in triangles), "index of a vertex")
    centers = numbers(sections, "CENT", "f", 3 * vertices)
    for x, y, z in zip(centers[::3], centers[1::3], centers[2::3]):
        check(abs((x * x + y * y + z * z) ** 0.5 - 1) <= 0.001, "centre")
    numbers(sections, "TANG", "f", 3 * vertices)
    places = list(struct.iter_unpack("<I6f", sections["PLAC"]))
    check(len(places) == faces and all(place[0] < pages for place in places), "places")
    if form == 0:
        shares = [value / 255 for value in numbers(sections, "ANGL", "B", samples)]
    elif form == 1:
        shares = numbers(sections, "ANGL", "e", samples)
    else:
        content = sections["ANGL"]
        floats = terms * (azimuths + 2)
        check(len(content) == 4 * floats + terms * texels, "length of ANGL")
        values, weights = struct.unpack_from(f"<{floats}f", content), content[4 * floats :]
        offsets, scales = values[terms * azimuths :][:terms], values[terms * (azimuths + 1) :]
        slice_texels = width * height
        shares = [0.0] * samples
        for sample in range(samples):
            page, rest = divmod(sample, slice_texels * azimuths)
            azimuth, texel = divmod(rest, slice_texels)
            for term in range(terms):
                weight = weights[term * texels + page * slice_texels + texel]
                share = (offsets[term] + scales[term] * weight / 255) * values[term * azimuths + azimuth]
                shares[sample] += share
    if "TCEN" in sections:
        numbers(sections, "TCEN", "e", 4 * texels)
    gaps = numbers(sections, "GAPS", "e", texels)
    colors = numbers(sections, "COLO", "B", 4 * details)
    numbers(sections, "NORM", "e", 4 * details)
    print(f"{vertices} vertices, {faces} faces, rule {rule}, form {form}, {terms} terms, detail {detail}")
    print(f"{pages} pages of {width} x {height} x {azimuths}")
    print(f"means: coordinate {mean(positions):.6f}, share {mean(shares):.6f}, gap {mean(gaps):.6f}, color {mean(colors):.6f}")
    for key, value in metadata(sections["META"]) if "META" in sections else []:
        print(f"{key} = {value!r}")


if __name__ == "__main__":
    main()
