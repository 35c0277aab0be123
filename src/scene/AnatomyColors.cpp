#include "scene/AnatomyColors.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "core/LabelVolume.h"

namespace velum::scene {

namespace {

using Words = std::vector<std::string>;

/// The words of a name, in small letters: "Left-Lateral-Ventricle", "lung_upper_lobe_left", "L5" is one.
Words wordsOf(std::string_view name) {
  Words words;
  std::string word;
  auto end = [&] {
    if (!word.empty()) words.push_back(std::move(word));
    word.clear();
  };
  for (char c : name) {
    auto u = static_cast<unsigned char>(c);
    if (std::isalnum(u))
      word += char(std::tolower(u));
    else
      end();
  }
  end();
  return words;
}

bool hasWord(const Words& words, std::string_view wanted) {
  // "vertebra" for "vertebrae", "lung" for "lungs": whoever begins with the wanted word and has an ending of a plural.
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    if (!word.starts_with(wanted)) return false;
    std::string_view ending = std::string_view(word).substr(wanted.size());
    return ending.empty() || ending == "s" || ending == "e" || ending == "es";
  });
}

/// A kind of tissue: names that have all words of one of the lists, parted by commas.
struct Tissue {
  glm::vec3 color;
  std::string_view names;
};

/// The first that fits counts: what is said more closely comes before what is said less so.
constexpr float k = 1.0f / 255.0f;
constexpr std::string_view kSkin = "skin,scalp,epidermis,dermis";
const Tissue kTissues[] = {
    {{160 * k, 200 * k, 80 * k}, "tumor,tumour,lesion,nodule,cancer,metastasis,metastase,neoplasm,cyst"},
    {{236 * k, 188 * k, 158 * k}, kSkin},
    {{240 * k, 214 * k, 128 * k}, "fat,adipose,subcutaneous"},
    {{242 * k, 217 * k, 92 * k}, "nerve,spinal cord,chiasm,plexus"},
    {{150 * k, 196 * k, 216 * k},
     "lateral ventricle,3rd ventricle,4th ventricle,5th ventricle,third ventricle,fourth ventricle,csf,lat vent,"
     "cerebrospinal"},
    {{72 * k, 108 * k, 190 * k}, "pulmonary artery,pulmonary arterie,pulmonary trunk"},
    {{204 * k, 44 * k, 38 * k}, "pulmonary vein"},
    {{72 * k, 108 * k, 190 * k}, "vein,vena,venous,cava,jugular,azygos"},
    {{204 * k, 44 * k, 38 * k},
     "artery,arterie,arterial,aorta,aortic,carotid,brachiocephalic trunk,celiac trunk,vessel"},
    {{176 * k, 74 * k, 64 * k}, "heart,myocardium,ventricle,atrium,atrial,auricle,pericardium"},
    {{170 * k, 208 * k, 220 * k}, "cartilage,disc,disk,meniscus"},
    {{232 * k, 224 * k, 208 * k}, "tendon,ligament,fascia,aponeurosis"},
    {{244 * k, 240 * k, 224 * k}, "tooth,teeth,molar,incisor,canine,premolar,enamel"},
    {{232 * k, 218 * k, 184 * k},
     "bone,skull,cranium,mandible,maxilla,vertebra,rib,sternum,clavicula,clavicle,scapula,humerus,radius,ulna,femur,"
     "tibia,fibula,patella,hip,sacrum,coccyx,pelvis,ilium,ischium,pubis,hyoid,spine,zygomatic,occipital bone,skeleton,"
     "carpal,scaphoid,lunate bone,triquetrum,triquetral,pisiform,trapezium,trapezoid,capitate,hamate,metacarpal,"
     "phalanx,phalange,tarsal,calcaneus,talus,navicular,cuboid,medial cuneiform,intermediate cuneiform,"
     "lateral cuneiform,metatarsal"},
    {{170 * k, 66 * k, 58 * k},
     "muscle,gluteus,iliopsoas,autochthon,psoas,quadriceps,bicep,tricep,deltoid,pectoralis,rectus,diaphragm,masseter,"
     "temporalis,sartorius,trapezius,latissimus,soleus,gastrocnemius,hamstring"},
    {{92 * k, 140 * k, 66 * k}, "gallbladder,gall bladder,bile,biliary"},
    {{150 * k, 74 * k, 52 * k}, "liver,hepatic"},
    {{140 * k, 60 * k, 84 * k}, "spleen,splenic"},
    {{222 * k, 172 * k, 96 * k}, "adrenal,suprarenal"},
    {{172 * k, 84 * k, 68 * k}, "kidney,renal"},
    {{230 * k, 188 * k, 124 * k}, "pancreas,pancreatic"},
    {{216 * k, 150 * k, 134 * k}, "stomach,gastric,esophagus,oesophagus"},
    {{224 * k, 164 * k, 142 * k}, "duodenum,bowel,intestine,jejunum,ileum"},
    {{202 * k, 140 * k, 120 * k}, "colon,rectum,cecum,caecum,appendix"},
    {{232 * k, 208 * k, 120 * k}, "bladder,urinary,ureter,urethra"},
    {{212 * k, 158 * k, 146 * k}, "prostate,uterus,ovary,ovarie,testis,teste,placenta,seminal vesicle"},
    {{206 * k, 220 * k, 226 * k}, "trachea,bronchus,bronchi,airway,larynx"},
    {{226 * k, 164 * k, 160 * k}, "lung,lobe upper,lobe middle,lobe lower,pulmonary"},
    {{190 * k, 96 * k, 80 * k}, "thyroid,thymus,parotid,gland"},
    {{238 * k, 232 * k, 216 * k}, "white matter,corpus callosum,tract"},
    {{220 * k, 188 * k, 170 * k},
     "brain,brainstem,cortex,cerebrum,cerebral,cerebellum,cerebellar,gyrus,hippocampus,thalamus,amygdala,caudate,"
     "putamen,"
     "pallidum,hypothalamus,midbrain,pons,medulla,insula,accumbens"},
    {{236 * k, 236 * k, 242 * k}, "eye,eyeball,sclera"},
};

bool fits(const Words& words, std::string_view names) {
  while (!names.empty()) {
    std::size_t end = std::min(names.find(','), names.size());
    Words wanted = wordsOf(names.substr(0, end));
    if (std::all_of(wanted.begin(), wanted.end(), [&](const std::string& word) { return hasWord(words, word); }))
      return true;
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return false;
}

}  // namespace

std::optional<glm::vec3> anatomyColor(std::string_view name) {
  Words words = wordsOf(name);
  for (const Tissue& tissue : kTissues)
    if (fits(words, tissue.names)) return tissue.color;
  return std::nullopt;
}

bool isSkin(std::string_view name) { return fits(wordsOf(name), kSkin); }

glm::vec3 solidColor(std::uint16_t id, std::string_view name) {
  constexpr float kShade = 0.035f, kCalm = 0.22f;
  if (auto known = anatomyColor(name)) return glm::clamp(*known + kShade * float(id % 3 - 1), 0.0f, 1.0f);
  return glm::mix(defaultLabelColor(id), glm::vec3(0.8f), kCalm);
}

}  // namespace velum::scene
