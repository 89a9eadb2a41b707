(define (problem test-14)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 - block)
  (:init
    (hand-empty) (on-table b1) (on-table b2) (clear b5) (clear b6)
    (on b4 b1) (on b3 b4) (on b5 b3) (on b6 b2))
  (:goal (and
    (on b4 b3) (on b6 b4) (on b1 b6))))
