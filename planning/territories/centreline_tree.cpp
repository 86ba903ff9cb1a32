#include "planning/territories/centreline_tree.h"

#include <algorithm>
#include <limits>
#include <map>

#include "planning/territories/place.h"
#include "planning/territories/site_forest.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
constexpr double kEndMm = 10;  ///< how far an end is looked at for its width; the way outside the liver that doubles its score
constexpr double kSmallPiece = 0.2;  ///< of the greatest piece's length in the liver
constexpr double kWideEnd = 0.5;     ///< of the widest end's squared radius: a piece may hang on this end as well
constexpr double kOwnOutletMm = 10;  ///< a piece that reaches this far out of the liver has an inflow or outflow of its own

struct Piece {
  Sites sites;
  std::int32_t root = -1;
  double inLiverMm = 0;
  double outsideMm = 0;          ///< from the root along the vessel to the liver; 0 where the root is inside, or nothing is
  std::int32_t attachedTo = -1;  ///< site of another piece
  std::int32_t tree = -1;
  bool loose = false;
};

class TreeMaker {
 public:
  TreeMaker(const CentrelineLinks& links, const ImageGeometry& geometry)
      : links_(links), forest_(links, geometry.spacing.maxCoeff()) {}

  CentrelineTree run(const std::string& name, const ExecutionContext& context) {
    for (Sites& sites : forest_.pieces()) {
      context.throwIfCancelled();
      Piece piece;
      piece.sites = std::move(sites);
      root(piece);
      pieces_.push_back(std::move(piece));
    }
    std::stable_sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.inLiverMm > b.inLiverMm; });
    join(context);
    return assemble(name);
  }

 private:
  [[nodiscard]] const VesselSite& site(std::int32_t s) const { return links_.sites[at(s)]; }

  /// Roots a piece at its best end and prunes it.
  void root(Piece& piece) {
    Sites inside;
    std::copy_if(piece.sites.begin(), piece.sites.end(), std::back_inserter(inside),
                 [&](std::int32_t s) { return site(s).inLiver; });
    std::map<std::int32_t, double> outside;
    if (!inside.empty()) {
      forest_.grow(piece.sites, inside);
      for (const std::int32_t s : piece.sites) {
        outside[s] = forest_.wayMm(s);
      }
    }
    const std::int32_t some = forest_.grow(piece.sites, {piece.sites.front()});
    forest_.grow(piece.sites, {some});
    const std::int32_t first = forest_.prune(piece.sites, some);
    double best = -1;
    for (const std::int32_t end : forest_.endsOf(piece.sites, first)) {
      const double score = widthOf(end) * (1 + (inside.empty() ? 0.0 : outside[end] / kEndMm));
      if (score > best) {
        best = score;
        piece.root = end;
        piece.outsideMm = inside.empty() ? 0.0 : outside[end];
      }
    }
    piece.root = piece.root < 0 ? first : piece.root;  // no end at all: a solid without arms
    forest_.grow(piece.sites, {piece.root});
    piece.root = forest_.prune(piece.sites, piece.root);
    for (const std::int32_t s : piece.sites) {
      if (!forest_.removed(s) && forest_.parent(s) >= 0 && site(s).inLiver) {
        piece.inLiverMm += forest_.wayMm(s) - forest_.wayMm(forest_.parent(s));
      }
    }
  }

  /// Mean squared radius near an end.
  [[nodiscard]] double widthOf(std::int32_t end) const {
    const Sites near = forest_.fromEnd(end, kEndMm);
    double sum = 0;
    for (const std::int32_t s : near) {
      sum += site(s).radiusMm * site(s).radiusMm;
    }
    return sum / static_cast<double>(near.size());
  }

  /// Which pieces are trees of their own, which continue another one, which are loose.
  void join(const ExecutionContext& context) {
    const double greatest = pieces_.empty() ? 0.0 : pieces_.front().inLiverMm;
    std::vector<Piece*> small;
    for (Piece& piece : pieces_) {
      if (&piece != &pieces_.front() && piece.inLiverMm < kSmallPiece * greatest && piece.outsideMm < kOwnOutletMm) {
        small.push_back(&piece);
      } else {
        piece.tree = trees_++;
        fill(piece);
      }
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (Piece* piece : small) {
        context.throwIfCancelled();
        if (piece->tree < 0 && attach(*piece)) {
          changed = true;
        }
      }
    }
    for (Piece* piece : small) {
      if (piece->tree < 0) {
        piece->tree = trees_++;
        piece->loose = true;
      }
    }
  }

  [[nodiscard]] static Index3 cellOf(const Vec3& p) {
    return {static_cast<int>(std::floor(p[0] / kBridgeMm)), static_cast<int>(std::floor(p[1] / kBridgeMm)),
            static_cast<int>(std::floor(p[2] / kBridgeMm))};
  }
  void fill(const Piece& piece) {
    for (const std::int32_t s : piece.sites) {
      if (!forest_.removed(s)) {
        treeOf_[s] = piece.tree;
        cells_[cellOf(site(s).positionMm)].push_back(s);
      }
    }
  }

  /// Joins a small piece to the tree nearest to one of its wide ends, which becomes its root.
  bool attach(Piece& piece) {
    const Sites ends = forest_.endsOf(piece.sites, piece.root);
    const double wide = kWideEnd * widthOf(piece.root);
    double best = kBridgeMm;
    std::int32_t root = piece.root;
    for (const std::int32_t end : ends) {
      const double before = best;
      if (widthOf(end) >= wide) {
        findNear(end, best, piece.attachedTo);
      }
      root = best < before ? end : root;
    }
    if (piece.attachedTo < 0) {
      return false;
    }
    piece.root = root;
    forest_.grow(piece.sites, {root});
    piece.tree = treeOf_[piece.attachedTo];
    fill(piece);
    return true;
  }

  /// The nearest site of a tree, where it is nearer than `best`.
  void findNear(std::int32_t end, double& best, std::int32_t& found) const {
    const Vec3& from = site(end).positionMm;
    const Index3 cell = cellOf(from);
    for (int n = 0; n < 27; ++n) {
      const auto sites = cells_.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (sites == cells_.end()) {
        continue;
      }
      for (const std::int32_t s : sites->second) {
        const double mm = (site(s).positionMm - from).norm();
        if (mm < best) {
          best = mm;
          found = s;
        }
      }
    }
  }

  CentrelineTree assemble(const std::string& name) const {
    CentrelineTree tree;
    tree.isLoose.assign(static_cast<std::size_t>(trees_), 0);
    std::vector<std::int32_t> numberOf(links_.sites.size(), -1);
    int joined = 0;
    int loose = 0;
    for (const Piece& piece : pieces_) {
      joined += piece.attachedTo >= 0 ? 1 : 0;
      loose += piece.loose ? 1 : 0;
      tree.isLoose[at(piece.tree)] = piece.loose ? 1 : 0;
      for (const std::int32_t s : piece.sites) {
        if (!forest_.removed(s)) {
          numberOf[at(s)] = static_cast<std::int32_t>(tree.sites.size());
          tree.sites.push_back(site(s));
          tree.sites.back().parent = s == piece.root ? piece.attachedTo : forest_.parent(s);
          tree.piece.push_back(piece.tree);
        }
      }
    }
    for (VesselSite& made : tree.sites) {
      made.parent = made.parent < 0 ? -1 : numberOf[at(made.parent)];
    }
    addNote(tree, joined,
            name + ": separate pieces taken for continuations of the branch nearest to them: " + std::to_string(joined));
    addNote(tree, loose,
            name + ": separate pieces that own nothing because what they hang on is not known: " + std::to_string(loose));
    return tree;
  }
  static void addNote(CentrelineTree& tree, int count, const std::string& sentence) {
    if (count > 0) {
      tree.notes.push_back(sentence);
    }
  }

  const CentrelineLinks& links_;
  SiteForest forest_;
  std::vector<Piece> pieces_;
  std::int32_t trees_ = 0;
  std::map<std::int32_t, std::int32_t> treeOf_;
  std::map<Index3, Sites> cells_;
};
}  // namespace

CentrelineTree centrelineTreeOf(const std::string& name, const Mask& vessel, const ImageGeometry& geometry, const Mask& liver,
                                const ExecutionContext& context) {
  const CentrelineLinks links = linkedCentreline(vessel, geometry, liver, context);
  if (links.sites.empty()) {
    return {};
  }
  return TreeMaker(links, geometry).run(name, context);
}

}  // namespace glisson
