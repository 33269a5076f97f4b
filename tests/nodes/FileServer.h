// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

/// Binds a socket to a free port of the loopback interface. @return the port.
inline unsigned listenOn(int server) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(server, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(server, 64) != 0 ||
        getsockname(server, reinterpret_cast<sockaddr*>(&address), &size) != 0)
        ADD_FAILURE() << "no server";
    return ntohs(address.sin_port);
}

inline std::string urlOf(unsigned port) {
    return "http://127.0.0.1:" + std::to_string(port);
}

/// Serves the files of a folder over HTTP on the loopback interface, one request after another.
class FileServer {
public:
    explicit FileServer(std::string folder)
        : _folder(std::move(folder)), _socket(socket(AF_INET, SOCK_STREAM, 0)) {
        _port = listenOn(_socket);
        _thread = std::thread([this] { serve(); });
    }
    ~FileServer() {
        _done = true;
        shutdown(_socket, SHUT_RDWR);
        _thread.join();
        close(_socket);
    }
    FileServer(const FileServer&) = delete;
    FileServer& operator=(const FileServer&) = delete;

    std::string url() const { return urlOf(_port); }
    /// Makes one request in `count` fail, by status 503, half a file or a closed connection. 0: no failures.
    void failOneIn(int count) { _failOneIn = count; }
    int failures() const { return _failures; }

private:
    void serve() {
        for (int request = 1; !_done; ++request) {
            const int client = accept(_socket, nullptr, nullptr);
            if (client < 0)
                continue;
            std::string head;
            char buffer[4096];
            while (head.find("\r\n\r\n") == std::string::npos) {
                const ssize_t count = read(client, buffer, sizeof buffer);
                if (count <= 0)
                    break;
                head.append(buffer, static_cast<std::size_t>(count));
            }
            answer(client, head.substr(head.find(' ') + 1, head.find(" HTTP") - head.find(' ') - 1),
                   _failOneIn > 0 && request % _failOneIn == 0);
            close(client);
        }
    }
    void answer(int client, const std::string& path, bool fail) {
        std::ifstream file(_folder + path, std::ios::binary);
        std::ostringstream body;
        body << file.rdbuf();
        std::string text = file ? "HTTP/1.0 200 OK\r\nContent-Length: " + std::to_string(body.str().size()) +
                                      "\r\n\r\n" + body.str()
                                : "HTTP/1.0 404 Not Found\r\nContent-Length: 0\r\n\r\n";
        if (fail) {
            const int way = _failures++ % 3;
            text = way == 0   ? "HTTP/1.0 503 Service Unavailable\r\nContent-Length: 4\r\n\r\nbusy"
                   : way == 1 ? text.substr(0, text.size() / 2)
                              : "";
        }
        for (std::size_t sent = 0; sent < text.size();) {
            const ssize_t count = send(client, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
            if (count <= 0)
                return;
            sent += static_cast<std::size_t>(count);
        }
    }

    std::string _folder;
    int _socket;
    unsigned _port = 0;
    std::atomic<bool> _done{false};
    std::atomic<int> _failOneIn{0}, _failures{0};
    std::thread _thread;
};

/// Accepts connections and never answers.
class SilentServer {
public:
    SilentServer() : _socket(socket(AF_INET, SOCK_STREAM, 0)) { _port = listenOn(_socket); }
    ~SilentServer() { close(_socket); }
    SilentServer(const SilentServer&) = delete;
    SilentServer& operator=(const SilentServer&) = delete;

    std::string url() const { return urlOf(_port); }

private:
    int _socket;
    unsigned _port;
};
