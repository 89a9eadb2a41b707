#pragma once

namespace cell {

/// Rows of a parts.yaml: a cabinet on the pedestal with a leaf on a hinge over
/// a tray on a slide. Its front is at -y. Shut, each stands before a stop that
/// it meets half a millimetre further in; a round one, since two boxes that
/// only just meet may be thrown apart (MuJoCo 2.2.2).
inline constexpr char kCabinetContacts[] =
    "  - [leaf, frame]\n"
    "  - [tray, frame]\n";
/// The same of a domain.yaml's types.
inline constexpr char kCabinetTypes[] =
    "  cabinet: part\n"
    "  leaf: part\n"
    "  tray: part\n";
inline constexpr char kCabinetParts[] = R"(
  cabinet:
    type: cabinet
    fixed: true
    symmetry_order: 1
    density: 500
    colour: [0.6, 0.6, 0.6]
    pieces:
      - {kind: box, center: [0, 0, 10], size: [300, 200, 20]}
      - {kind: box, center: [145, 0, 120], size: [10, 200, 200], mirror_x: true}
      - {kind: box, center: [0, 0, 120], size: [280, 200, 10]}
      - {kind: cylinder, center: [120, -94.5, 172], axis: x, radius: 5, length: 20, contact: frame, shape: false}
      - {kind: cylinder, center: [120, -94.5, 60], axis: x, radius: 5, length: 20, contact: frame, shape: false}
  leaf:
    type: leaf
    symmetry_order: 1
    density: 300
    colour: [0.8, 0.8, 0.7]
    pieces:
      - {kind: box, center: [150, -5, 0], size: [296, 10, 90], contact: leaf}
      - {kind: box, center: [280, -20, 0], size: [12, 20, 60], contact: leaf}
    joint:
      on: cabinet
      xyz: [-150, -100, 172]
      kind: hinge
      axis: [0, 0, -1]
      at: [0, 0, 0]
      limits_deg: [-0.2, 100]
      friction: 0.3
      damping: 0.2
    handle: {xyz: [280, -25, 0], rpy: [90, 0, 0], width: 12}
  tray:
    type: tray
    symmetry_order: 1
    density: 300
    colour: [0.7, 0.8, 0.8]
    pieces:
      - {kind: box, center: [0, 90, 0], size: [200, 180, 70]}
      - {kind: box, center: [0, -5, 0], size: [296, 10, 90], contact: tray}
      - {kind: box, center: [0, -20, 0], size: [60, 20, 12], contact: tray}
    joint:
      on: cabinet
      xyz: [0, -100, 60]
      kind: slide
      axis: [0, -1, 0]
      limits_mm: [-1, 150]
      friction: 4
      damping: 10
    handle: {xyz: [0, -25, 0], rpy: [90, -90, 0], width: 12}
)";

}  // namespace cell
