#include <optional>

#include "sim/passes/dab_region.h"
#include "sim/passes/mask.h"
#include "sim/passes/paint.h"
#include "sim/passes/passes.h"

namespace talus {
namespace {

// What is painted: by dabs, or as a mask made of the terrain.
class PaintPass : public Pass {
  public:
    std::string name() const override { return "paint"; }

    bool act(Terrain& terrain, const Moment& /*at*/, const PassAct& act) override {
        if (const auto* mask = std::get_if<MaskSettings>(&act)) {
            if (!mask_) mask_.emplace();
            mask_->make(terrain, *mask);
            return true;
        }
        const auto* dab = std::get_if<Dab>(&act);
        if (!dab || !dab->is_paint()) return false;
        if (is_masked_out(terrain, *dab)) return true;
        if (!paint_) paint_.emplace();
        paint_->dab(terrain, *dab);
        return true;
    }

  private:
    // Made when they are needed: each compiles its shader.
    std::optional<Paint> paint_;
    std::optional<Mask> mask_;
};

}  // namespace

PassKind paint_pass() {
    return {[](const Terrain&) -> std::unique_ptr<Pass> { return std::make_unique<PaintPass>(); }};
}

}  // namespace talus
