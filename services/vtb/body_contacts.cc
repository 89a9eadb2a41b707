#include "services/vtb/body_contacts.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "services/vtb/world_xml.h"

namespace cell::vtb {
namespace {

std::string NameOf(const mjModel& model, int geom) {
  const int body = model.geom_bodyid[geom];
  return body == 0 ? kTableName : mj_id2name(&model, mjOBJ_BODY, body);
}

}  // namespace

std::vector<BodyContact> ContactsOf(const mjModel& model, const mjData& data) {
  std::map<std::pair<std::string, std::string>, BodyContact> pairs;
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    std::string first = NameOf(model, contact.geom1);
    std::string second = NameOf(model, contact.geom2);
    if (second < first) std::swap(first, second);
    const auto [it, is_new] = pairs.try_emplace({first, second});
    BodyContact& pair = it->second;
    mjtNum force[6];
    mj_contactForce(&model, &data, i, force);
    pair.normal_force += force[0];
    if (is_new || contact.dist < pair.distance) {
      pair.first = first;
      pair.second = second;
      pair.distance = contact.dist;
      pair.p_W =
          Eigen::Vector3d(contact.pos[0], contact.pos[1], contact.pos[2]);
    }
  }
  std::vector<BodyContact> contacts;
  for (auto& [names, contact] : pairs) contacts.push_back(std::move(contact));
  return contacts;
}

void SortByNames(std::vector<BodyContact>* contacts) {
  std::ranges::sort(*contacts, [](const BodyContact& a, const BodyContact& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
}

}  // namespace cell::vtb
