(define (problem test-20)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 b8 - block)
  (:init
    (hand-empty) (on-table b1) (on-table b7) (on-table b8) (clear b6)
    (clear b2) (clear b5) (on b6 b1) (on b3 b7) (on b4 b3) (on b2 b4)
    (on b5 b8))
  (:goal (and
    (on b5 b4) (on b6 b5) (on b7 b6) (on b1 b7) (on b2 b3))))
