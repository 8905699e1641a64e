// Tarjan's algorithm (1972) without recursion: scripts may chain any number of declarations.
#include "checker/cspm/types/groups.hpp"

#include <algorithm>
#include <limits>

namespace robochart::cspm::types {

namespace {

class Components {
public:
    explicit Components(const DeclarationList& list) : nodes_(list.items.size()) {
        for (const Declaration& each : list.items) {
            std::vector<std::size_t>& edges = nodes_[each.index].edges;
            for (const Symbol* used : each.uses) {
                if (used->owner != nullptr && used->owner->list == &list) edges.push_back(used->owner->index);
            }
            std::ranges::sort(edges);
            edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        }
    }

    std::vector<std::vector<std::size_t>> run() {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (nodes_[i].order == unseen) explore(i);
        }
        return std::move(found_);
    }

private:
    static constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
    struct Node {
        std::vector<std::size_t> edges;
        std::size_t order = unseen;
        std::size_t low = 0;
        std::size_t next = 0;
        bool open = false;
    };

    void enter(std::size_t index) {
        nodes_[index].order = nodes_[index].low = count_++;
        nodes_[index].open = true;
        open_.push_back(index);
        path_.push_back(index);
    }

    void explore(std::size_t start) {
        enter(start);
        while (!path_.empty()) {
            const std::size_t index = path_.back();
            Node& node = nodes_[index];
            if (node.next < node.edges.size()) {
                const std::size_t to = node.edges[node.next++];
                if (nodes_[to].order == unseen) {
                    enter(to);
                } else if (nodes_[to].open) {
                    node.low = std::min(node.low, nodes_[to].order);
                }
                continue;
            }
            path_.pop_back();
            if (!path_.empty()) nodes_[path_.back()].low = std::min(nodes_[path_.back()].low, node.low);
            if (node.low == node.order) close(index);
        }
    }

    void close(std::size_t root) {
        std::vector<std::size_t>& component = found_.emplace_back();
        std::size_t index = 0;
        do {
            index = open_.back();
            open_.pop_back();
            nodes_[index].open = false;
            component.push_back(index);
        } while (index != root);
        std::ranges::sort(component);
    }

    std::vector<Node> nodes_;
    std::vector<std::size_t> open_;
    std::vector<std::size_t> path_;
    std::vector<std::vector<std::size_t>> found_;
    std::size_t count_ = 0;
};

}  // namespace

std::vector<std::vector<Declaration*>> dependency_groups(DeclarationList& list) {
    std::vector<std::vector<Declaration*>> result;
    for (const std::vector<std::size_t>& component : Components(list).run()) {
        std::vector<Declaration*>& group = result.emplace_back();
        for (const std::size_t index : component) group.push_back(&list.items[index]);
    }
    return result;
}

}  // namespace robochart::cspm::types
